#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace leitstand::detail {

/// What separates the fields of a line.
enum class Separators : bool { Blanks, BlanksAndCommas };  ///< BlanksAndCommas: semicolons, too

/// Removes the next field from the front of @p line and returns it; empty when there is none. Consecutive
/// separators count as one.
[[nodiscard]] std::string_view takeField(std::string_view& line, Separators separators = Separators::Blanks);

/// Converts the whole of @p field to a number ("nan" and "inf" included). Empty when it is no number or
/// overflows.
[[nodiscard]] std::optional<double> toNumber(std::string_view field);
/// Converts the whole of @p field to a whole number of at least 0. Empty when it is no such number or
/// overflows.
[[nodiscard]] std::optional<std::size_t> toCount(std::string_view field);

/// Returns @p text in lower case, ASCII only.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// Appends the shortest text from which exactly the same number is read.
void appendNumber(std::string& text, float value);
void appendNumber(std::string& text, double value);

/// Appends @p metres in centimetres. It has just enough digits that reading it and dividing by 100 gives
/// exactly the same float.
void appendCentimetres(std::string& text, float metres);

}  // namespace leitstand::detail
