#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace leitstand::detail {

/// What separates the fields of a line.
enum class Separators : bool { Blanks, BlanksAndCommas };  ///< commas: semicolons too

/// Takes the next field off the front of @p line; empty when there is none. Runs of separators count as one.
[[nodiscard]] std::string_view takeField(std::string_view& line, Separators separators = Separators::Blanks);

/// The whole of @p field as a number ("nan" and "inf" included); nothing when it is none or overflows.
[[nodiscard]] std::optional<double> toNumber(std::string_view field);
/// The whole of @p field as a whole number from 0 on; nothing when it is none or overflows.
[[nodiscard]] std::optional<std::size_t> toCount(std::string_view field);

/// @p text in small letters, ASCII only.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// Appends the shortest text that reads back as the very same number.
void appendNumber(std::string& text, float value);
void appendNumber(std::string& text, double value);

/// Appends @p metres in centimetres, with just enough digits that reading and dividing by 100 gives the very
/// same float.
void appendCentimetres(std::string& text, float metres);

}  // namespace leitstand::detail
