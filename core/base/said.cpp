#include "core/base/said.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace leitstand {
namespace {

constexpr std::string_view Gap = "{}";
constexpr std::string_view Speaks = ": ";
constexpr std::size_t LongestSaid = 4'096;  // characters

/// Returns the texts of @p said at the gaps of @p words; empty when it is not of that form.
std::optional<std::vector<std::string>> valuesIn(std::string_view said, std::string_view words) {
    std::vector<std::string> values;
    auto gap = words.find(Gap);
    if (!said.starts_with(words.substr(0, gap))) return std::nullopt;
    said.remove_prefix(std::min(said.size(), gap));
    while (gap != std::string_view::npos) {
        words.remove_prefix(gap + Gap.size());
        gap = words.find(Gap);
        const std::string_view next = words.substr(0, gap);
        const bool last = gap == std::string_view::npos;
        if (said.size() <= next.size()) return std::nullopt;
        // A gap takes at least one character; the last one takes all that is left.
        const auto end = last ? said.size() - next.size() : said.find(next, 1);
        if (end == std::string_view::npos || !said.substr(end).starts_with(next)) return std::nullopt;
        values.emplace_back(said.substr(0, end));
        said.remove_prefix(end + next.size());
    }
    return values;
}

}  // namespace

SaidSentence knownSentence(std::string_view said, std::span<const char* const> known) {
    for (const char* const words : known) {
        if (said == words) return {words, {}};
    }
    for (const char* const words : known) {
        if (std::string_view(words).find(Gap) == std::string_view::npos) continue;
        if (auto values = valuesIn(said, words)) return {words, std::move(*values)};
    }
    return {};
}

SaidSentence knownEnding(std::string_view said, std::span<const char* const> known) {
    if (said.size() > LongestSaid) return {};
    for (auto at = said.rfind(Speaks); at != std::string_view::npos; at = said.rfind(Speaks, at - 1)) {
        SaidSentence found = knownSentence(said.substr(at + Speaks.size()), known);
        if (found.words != nullptr) return found;
        if (at == 0) break;
    }
    return knownSentence(said, known);
}

std::optional<double> figureIn(std::string_view said) {
    double value = 0.0;
    const auto [end, problem] = std::from_chars(said.data(), said.data() + said.size(), value);
    const bool whole = problem == std::errc() && end == said.data() + said.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string saidFigure(double value, int decimals) {
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
