#include "app/services/handin/report_text.h"

#include <ctime>

#include <fmt/format.h>

namespace leitstand {
namespace {

std::tm localParts(Time time) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(time).time_since_epoch();
    const auto whole = static_cast<std::time_t>(seconds.count());
    std::tm parts{};
    ::localtime_r(&whole, &parts);
    return parts;
}

}  // namespace

std::string dateText(Time time) {
    const std::tm parts = localParts(time);
    return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

std::string clockText(Time time) {
    const std::tm parts = localParts(time);
    return fmt::format("{:02}:{:02}:{:02}", parts.tm_hour, parts.tm_min, parts.tm_sec);
}

std::string spanText(std::chrono::nanoseconds span) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(span).count();
    if (seconds >= 3600)
        return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
    return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace leitstand
