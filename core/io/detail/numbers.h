#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace leitstand::detail {

/// What separates the fields of a line.
enum class Separators : bool { Blanks, BlanksAndCommas };  ///< BlanksAndCommas: semicolons, too

/// Removes the next field from the front of @p line; empty: there is none. Runs of separators count as one.
[[nodiscard]] std::string_view takeField(std::string_view& line, Separators separators = Separators::Blanks);

/// Returns all of @p field as a number ("nan" and "inf" included); empty when it is none or overflows.
[[nodiscard]] std::optional<double> toNumber(std::string_view field);
/// Returns all of @p field as a whole number from 0 on; empty when it is none or overflows.
[[nodiscard]] std::optional<std::size_t> toCount(std::string_view field);

/// Returns @p text in lower case, ASCII only.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// Appends the shortest text that reads back as exactly the same number.
void appendNumber(std::string& text, float value);
void appendNumber(std::string& text, double value);

/// Appends @p metres in centimetres, with just enough digits that reading and dividing by 100 gives exactly
/// the same float.
void appendCentimetres(std::string& text, float metres);

}  // namespace leitstand::detail
