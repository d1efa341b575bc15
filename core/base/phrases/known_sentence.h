#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// A received sentence, matched to a known one.
struct KnownSentence {
    const char* words = nullptr;           ///< the known sentence; null: none matches
    std::vector<std::string> values = {};  ///< texts at its "{}", in order
};
/// Returns which of @p known @p text is; "{}" stands for any text that is not empty. Sentences without "{}"
/// are tried first.
[[nodiscard]] KnownSentence knownSentence(std::string_view text, std::span<const char* const> known);

/// Returns which of @p known @p text ends with, as after the name of a speaker: "Kurt: stands". The shortest
/// end that fits counts; a text far longer than any sentence matches none.
[[nodiscard]] KnownSentence knownEnding(std::string_view text, std::span<const char* const> known);

/// The finite number that the whole of @p text is; empty when it is none.
[[nodiscard]] std::optional<double> figureIn(std::string_view text);
/// A number as such sentences contain it: "12", "0.4".
[[nodiscard]] std::string loggedFigure(double value, int decimals = 0);

/// Returns @p words with @p values at its "{}", in order; a "{}" without a value stays.
[[nodiscard]] std::string withValues(std::string words, const std::vector<std::string>& values);

}  // namespace leitstand
