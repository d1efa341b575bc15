#pragma once

#include <string>
#include <string_view>

namespace leitstand {

/// @p text for a terminal or a log of lines: control characters, line ends among them, characters that turn
/// the direction of writing, and bytes that are no UTF-8 become escapes (\n, \x1b, \u202e, \xff), so that
/// nobody's name moves the cursor, colours the screen or looks like two lines.
[[nodiscard]] std::string printable(std::string_view text);

/// The same, but lines stay lines: for text of several that is made here.
[[nodiscard]] std::string printableLines(std::string_view text);

/// @p json, as a writer of JSON made it, with escapes in place of what would reach a terminal raw: DEL, the
/// control characters above it and those that turn the direction of writing.
[[nodiscard]] std::string printableJson(std::string_view json);

}  // namespace leitstand
