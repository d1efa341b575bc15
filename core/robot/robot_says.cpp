#include "core/robot/robot_says.h"

#include <string_view>

#include "core/base/said.h"

namespace leitstand::robot_says {
namespace {

constexpr std::string_view Between = "; ";

Part partOf(std::string_view said) {
    const SaidSentence known = knownSentence(said, All);
    if (known.words == nullptr) return {nullptr, std::string(said)};
    return {known.words, known.values.empty() ? std::string() : known.values.front()};
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
