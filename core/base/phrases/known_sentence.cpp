#include "core/base/phrases/known_sentence.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace leitstand {
namespace {

constexpr std::string_view Gap = "{}";
constexpr std::string_view Speaks = ": ";
constexpr std::size_t LongestText = 4'096;  // characters

/// Returns the texts of @p text at the gaps of @p words; empty when it is not of that form.
std::optional<std::vector<std::string>> valuesIn(std::string_view text, std::string_view words) {
    std::vector<std::string> values;
    auto gap = words.find(Gap);
    if (!text.starts_with(words.substr(0, gap))) return std::nullopt;
    text.remove_prefix(std::min(text.size(), gap));
    while (gap != std::string_view::npos) {
        words.remove_prefix(gap + Gap.size());
        gap = words.find(Gap);
        const std::string_view next = words.substr(0, gap);
        const bool last = gap == std::string_view::npos;
        if (text.size() <= next.size()) return std::nullopt;
        // A gap takes at least one character; the last one takes all that is left.
        const auto end = last ? text.size() - next.size() : text.find(next, 1);
        if (end == std::string_view::npos || !text.substr(end).starts_with(next)) return std::nullopt;
        values.emplace_back(text.substr(0, end));
        text.remove_prefix(end + next.size());
    }
    return values;
}

}  // namespace

KnownSentence knownSentence(std::string_view text, std::span<const char* const> known) {
    for (const char* const words : known) {
        if (text == words) return {words, {}};
    }
    for (const char* const words : known) {
        if (std::string_view(words).find(Gap) == std::string_view::npos) continue;
        if (auto values = valuesIn(text, words)) return {words, std::move(*values)};
    }
    return {};
}

KnownSentence knownEnding(std::string_view text, std::span<const char* const> known) {
    if (text.size() > LongestText) return {};
    for (auto at = text.rfind(Speaks); at != std::string_view::npos; at = text.rfind(Speaks, at - 1)) {
        KnownSentence found = knownSentence(text.substr(at + Speaks.size()), known);
        if (found.words != nullptr) return found;
        if (at == 0) break;
    }
    return knownSentence(text, known);
}

std::optional<double> figureIn(std::string_view text) {
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = problem == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string loggedFigure(double value, int decimals) {
    return fmt::format("{:.{}f}", value, decimals);
}

std::string withValues(std::string words, const std::vector<std::string>& values) {
    std::size_t from = 0;
    for (const std::string& value : values) {
        const auto gap = words.find(Gap, from);
        if (gap == std::string::npos) break;
        words.replace(gap, Gap.size(), value);
        from = gap + value.size();
    }
    return words;
}

}  // namespace leitstand
