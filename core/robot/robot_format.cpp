#include "core/robot/robot_format.h"

#include <string_view>

#include "core/base/phrases/known_sentence.h"

namespace leitstand::robot_format {
namespace {

constexpr std::string_view Between = "; ";

Part partOf(std::string_view reported) {
    const KnownSentence known = knownSentence(reported, All);
    if (known.words == nullptr) return {nullptr, std::string(reported)};
    return {known.words, known.values.empty() ? std::string() : known.values.front()};
}

}  // namespace

std::vector<Part> partsOf(const std::string& reported) {
    std::vector<Part> parts;
    std::string_view rest = reported;
    for (auto cut = rest.find(Between); cut != std::string_view::npos; cut = rest.find(Between)) {
        parts.push_back(partOf(rest.substr(0, cut)));
        rest.remove_prefix(cut + Between.size());
    }
    if (!rest.empty()) parts.push_back(partOf(rest));
    return parts;
}

}  // namespace leitstand::robot_format
