#include "core/io/yaml/yaml_errors.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/base/words.h"

namespace leitstand::detail {
namespace {

constexpr std::size_t LongestQuote = 40;  ///< [B]
constexpr std::size_t LongestWord = 64;   ///< of a word to compare with others [B]
constexpr std::size_t MostErrors = 100;   ///< that are reported
constexpr std::size_t MostKept = 10'000;  ///< kept, so that the reported ones are the first
constexpr std::size_t MostAlternatives = 40;

/// Returns the Levenshtein distance.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
        }
    }
    return row.back();
}

}  // namespace

std::string shown(std::string_view text) {
    std::size_t end = text.size();
    if (end > LongestQuote) {
        end = LongestQuote;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // UTF-8 goes on
    }
    std::string result = "\"";
    for (const char c : text.substr(0, end)) {
        const auto code = static_cast<unsigned char>(c);
        result += code < 0x20 || code == 0x7F ? fmt::format("\\x{:02x}", code) : std::string(1, c);
    }
    return result + (end < text.size() ? "...\"" : "\"");
}

std::string shown(const YAML::Node& node) {
    if (node.IsMap()) return translate("leitstand::Error", "keys and values");
    if (node.IsSequence()) return leitstand::fill(translate("leitstand::Error", "a list of {}"), node.size());
    return node.IsScalar() ? shown(node.Scalar()) : translate("leitstand::Error", "nothing");
}

std::string likely(std::string_view word, const std::vector<std::string>& words) {
    if (word.empty() || word.size() > LongestWord || words.empty()) return {};
    const auto nearest = std::min_element(words.begin(), words.end(), [&](const auto& a, const auto& b) {
        return distance(a, word) < distance(b, word);
    });
    if (distance(*nearest, word) > 1 + word.size() / 4) return {};
    return leitstand::fill(translate("leitstand::Error", ", did you mean {}?"), *nearest);
}

std::string anyOf(const std::vector<std::string>& words) {
    std::string text;
    const std::size_t count = std::min(words.size(), MostAlternatives);
    for (std::size_t i = 0; i < count; ++i) {
        if (i == 0) {
            text = words[i];
        } else if (i + 1 < words.size()) {
            text += ", " + words[i];
        } else {
            text = leitstand::fill(translate("leitstand::Error", "{} or {}"), text, words[i]);
        }
    }
    return text + (count < words.size() ? " ..." : "");
}

void YamlErrors::add(int line, const std::string& path, const std::string& text) {
    if (m_lines.size() >= MostKept) {
        ++m_unreported;
        return;
    }
    m_lines.emplace_back(line,
                         fmt::format("{}:{}: {}{}{}", m_file, line, path, path.empty() ? "" : ": ", text));
}

Error YamlErrors::error() const {
    auto lines = m_lines;
    std::stable_sort(lines.begin(), lines.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string text;
    for (std::size_t i = 0; i < std::min(lines.size(), MostErrors); ++i) {
        text += (i == 0 ? "" : "\n") + lines[i].second;
    }
    if (lines.size() > MostErrors)
        text += '\n' + leitstand::fill(translate("leitstand::Error", "{}: {} errors more"), m_file,
                                       lines.size() - MostErrors + m_unreported);
    return Error{text};
}

int lineOf(const YAML::Node& node) {
    return std::max(0, node.Mark().line) + 1;
}

}  // namespace leitstand::detail
