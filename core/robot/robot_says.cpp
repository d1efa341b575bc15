#include "core/robot/robot_says.h"

#include <string_view>

namespace leitstand::robot_says {
namespace {

constexpr std::string_view Gap = "{}", Between = "; ";

Part partOf(std::string_view said) {
    for (const std::string_view words : All) {
        if (words == said) return {words.data(), {}};
    }
    for (const std::string_view words : All) {
        const auto gap = words.find(Gap);
        if (gap == std::string_view::npos) continue;
        const std::string_view before = words.substr(0, gap), after = words.substr(gap + Gap.size());
        if (said.size() <= before.size() + after.size()) continue;
        if (!said.starts_with(before) || !said.ends_with(after)) continue;
        said.remove_prefix(before.size());
        said.remove_suffix(after.size());
        return {words.data(), std::string(said)};
    }
    return {nullptr, std::string(said)};
}

}  // namespace

std::vector<Part> partsOf(const std::string& said) {
    std::vector<Part> parts;
    std::string_view rest = said;
    for (auto cut = rest.find(Between); cut != std::string_view::npos; cut = rest.find(Between)) {
        parts.push_back(partOf(rest.substr(0, cut)));
        rest.remove_prefix(cut + Between.size());
    }
    if (!rest.empty()) parts.push_back(partOf(rest));
    return parts;
}

}  // namespace leitstand::robot_says
