#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// A received sentence, matched to a known one.
struct SaidSentence {
    const char* words = nullptr;           ///< the known sentence; null: none matches
    std::vector<std::string> values = {};  ///< texts at its "{}", in order
};
/// Returns which of @p known @p said is; "{}" stands for any text that is not empty. Sentences without "{}"
/// are tried first.
[[nodiscard]] SaidSentence knownSentence(std::string_view said, std::span<const char* const> known);

/// Returns which of @p known @p said ends with, as after the name of a speaker: "Kurt: stands". The shortest
/// end that fits counts; a text far longer than any sentence matches none.
[[nodiscard]] SaidSentence knownEnding(std::string_view said, std::span<const char* const> known);

/// The finite number that the whole of @p said is; empty when it is none.
[[nodiscard]] std::optional<double> figureIn(std::string_view said);
/// A number as such sentences contain it: "12", "0.4".
[[nodiscard]] std::string saidFigure(double value, int decimals = 0);

/// Returns @p words with @p values at its "{}", in order; a "{}" without a value stays.
[[nodiscard]] std::string withValues(std::string words, const std::vector<std::string>& values);

}  // namespace leitstand
