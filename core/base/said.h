#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// A sentence that was said, known again.
struct SaidSentence {
    const char* words = nullptr;           ///< one of those that are known; null: it is none of them
    std::vector<std::string> values = {};  ///< what stands at its "{}", in order
};
/// Which of @p known @p said is; "{}" stands for whatever is not empty. Plain ones go first.
[[nodiscard]] SaidSentence knownSentence(std::string_view said, std::span<const char* const> known);

/// Which of @p known @p said ends with: who speaks goes before it, "Kurt: stands". The shortest end that
/// fits; what is far longer than any sentence is none.
[[nodiscard]] SaidSentence knownEnding(std::string_view said, std::span<const char* const> known);

/// The finite number that all of @p said is; empty: it is none.
[[nodiscard]] std::optional<double> figureIn(std::string_view said);
/// A number as it is said: "12", "0.4".
[[nodiscard]] std::string saidFigure(double value, int decimals = 0);

/// @p words with @p values at its "{}", in order; those that are missing stay "{}".
[[nodiscard]] std::string withValues(std::string words, const std::vector<std::string>& values);

}  // namespace leitstand
