#include "transport/dds/names.h"

#include <vector>

namespace leitstand {
namespace {

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const auto end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + separator.size());
    }
}

}  // namespace

std::string ddsTopicOf(std::string_view rosTopic) {
    return rosTopic.starts_with('/') ? "rt" + std::string(rosTopic) : std::string(rosTopic);
}

std::string rosTopicOf(std::string_view ddsTopic) {
    return std::string(ddsTopic.starts_with("rt/") ? ddsTopic.substr(2) : ddsTopic);
}

bool isRosTopic(std::string_view ddsTopic) {
    return ddsTopic.starts_with("rt/") || ddsTopic.starts_with("rq/") || ddsTopic.starts_with("rr/");
}

std::string ddsTypeOf(std::string_view rosType) {
    const auto parts = split(rosType, "/");
    if (parts.size() != 3 || parts[0].empty() || parts[1].empty() || parts[2].empty()) {
        return std::string(rosType);
    }
    std::string name(parts[0]);
    name.append("::").append(parts[1]).append("::dds_::").append(parts[2]).append("_");
    return name;
}

std::string rosTypeOf(std::string_view ddsType) {
    const auto parts = split(ddsType, "::");
    const bool ros = parts.size() == 4 && !parts[0].empty() && !parts[1].empty() && parts[2] == "dds_" &&
                     parts[3].size() > 1 && parts[3].ends_with('_');
    if (!ros) return std::string(ddsType);
    std::string name(parts[0]);
    name.append("/").append(parts[1]).append("/").append(parts[3].substr(0, parts[3].size() - 1));
    return name;
}

}  // namespace leitstand
