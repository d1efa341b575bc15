#include "core/io/clouds/tum.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/io/detail/line_reader.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/output_file.h"
#include "core/io/detail/pose_text.h"

namespace leitstand {

namespace {

constexpr std::int64_t Nanoseconds = 1'000'000'000;
constexpr std::int64_t MostSeconds = 9'000'000'000;  // what 64 bits of nanoseconds hold

Time fromNanoseconds(std::int64_t nanoseconds) {
    return Time(std::chrono::nanoseconds(nanoseconds));
}

/// Parses seconds since the epoch. "12.345" is read by its digits: a double holds today's time only to 0.2
/// us.
std::optional<Time> toTime(std::string_view field) {
    const bool negative = field.starts_with('-');
    const std::string_view digits = field.substr(negative ? 1 : 0);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const auto seconds = detail::toCount(digits.substr(0, point));
    std::string fraction(digits.substr(std::min(point + 1, digits.size())));
    const bool decimal = fraction.find_first_not_of("0123456789") == std::string::npos;
    if (seconds && decimal) {
        if (*seconds > static_cast<std::size_t>(MostSeconds)) return std::nullopt;
        fraction.resize(9, '0');
        const auto rest = static_cast<std::int64_t>(detail::toCount(fraction).value_or(0));
        const std::int64_t total = static_cast<std::int64_t>(*seconds) * Nanoseconds + rest;
        return fromNanoseconds(negative ? -total : total);
    }
    const auto number = detail::toNumber(field);  // such as 1.7e9
    if (!number || !(std::abs(*number) <= static_cast<double>(MostSeconds))) return std::nullopt;
    return fromNanoseconds(std::llround(*number * static_cast<double>(Nanoseconds)));
}

void appendTime(std::string& text, Time time) {
    const std::int64_t total = time.time_since_epoch().count();
    const auto size =
        total < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(total) : static_cast<std::uint64_t>(total);
    text += fmt::format("{}{}.{:09}", total < 0 ? "-" : "", size / Nanoseconds, size % Nanoseconds);
}

/// Parses the pose of a line; returns what was expected instead, if anything.
std::optional<std::string_view> takePose(std::string_view line, TimedPose& into) {
    constexpr std::string_view Expectation = "t x y z qx qy qz qw";
    const auto time = toTime(detail::takeField(line));
    if (!time) return Expectation;
    into.time = *time;
    return detail::takePose(line, into.pose, Expectation);
}

}  // namespace

Result<std::vector<TimedPose>> readTum(const std::filesystem::path& file) {
    auto opened = detail::LineReader::open(file);
    if (!opened) return opened.error();
    detail::LineReader reader = std::move(opened).value();
    std::vector<TimedPose> poses;
    std::string_view line;
    while (reader.next(line)) {
        std::string_view rest = line;
        const std::string_view first = detail::takeField(rest);
        if (first.empty() || first.front() == '#') continue;
        TimedPose pose;
        if (const auto expectation = takePose(line, pose)) return reader.mismatch(*expectation, line);
        poses.push_back(pose);
    }
    if (reader.failure()) return *reader.failure();
    if (poses.empty()) return reader.incomplete("poses, found none");
    return poses;
}

Result<void> writeTum(const std::filesystem::path& file, const std::vector<TimedPose>& poses) {
    std::string text = "# t x y z qx qy qz qw\n";
    for (const TimedPose& pose : poses) {
        appendTime(text, pose.time);
        const Eigen::Vector3d position = pose.pose.translation();
        Eigen::Quaterniond rotation(pose.pose.linear());
        if (rotation.w() < 0.0) rotation.coeffs() = -rotation.coeffs();
        for (const double number : {position.x(), position.y(), position.z(), rotation.x(), rotation.y(),
                                    rotation.z(), rotation.w()}) {
            text += ' ';
            detail::appendNumber(text, number);
        }
        text += '\n';
    }
    return detail::writeWhole(file, text);
}

}  // namespace leitstand
