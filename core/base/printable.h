#pragma once

#include <string>
#include <string_view>

namespace leitstand {

/// Returns @p text made safe for a terminal or a log of lines. Control characters (including line ends),
/// characters that change the direction of writing, and bytes that are not UTF-8 become escapes (
/// , \x1b, \u202e, \xff). So a received name cannot move the cursor, colour the screen or look like two
/// lines.
[[nodiscard]] std::string printable(std::string_view text);

/// As printable(), but line ends are kept: for texts of several lines made by the program.
[[nodiscard]] std::string printableLines(std::string_view text);

/// Returns @p json, the output of a JSON writer, with escapes for characters that a terminal would obey.
/// These are DEL, the control characters above it, and characters that change the direction of writing.
[[nodiscard]] std::string printableJson(std::string_view json);

}  // namespace leitstand
