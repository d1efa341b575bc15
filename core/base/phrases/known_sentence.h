#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// A received sentence that was matched to a known one.
struct KnownSentence {
    const char* words = nullptr;           ///< the known sentence; null: none matches
    std::vector<std::string> values = {};  ///< what the text has in place of each "{}", in order
};
/// Finds the one of @p known that @p text is. A "{}" in it stands for any text that is not empty. Sentences
/// without "{}" are tried first.
[[nodiscard]] KnownSentence knownSentence(std::string_view text, std::span<const char* const> known);

/// Finds the one of @p known that @p text is, or with which it ends after ": ", as in "Kurt: stands" after
/// the name of a speaker. The shortest ending that matches is used. A text of more than 4096 bytes matches
/// none.
[[nodiscard]] KnownSentence knownEnding(std::string_view text, std::span<const char* const> known);

/// Parses @p text as a finite number; empty when any part of it is something else.
[[nodiscard]] std::optional<double> figureIn(std::string_view text);
/// Returns @p value with @p decimals decimals, as in sentences of the log: "12", "0.4".
[[nodiscard]] std::string loggedFigure(double value, int decimals = 0);

/// Returns @p words with @p values in place of its "{}", in order. A "{}" without a value is kept.
[[nodiscard]] std::string withValues(std::string words, const std::vector<std::string>& values);

}  // namespace leitstand
