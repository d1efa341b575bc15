#pragma once

#include <string>
#include <string_view>

namespace leitstand {

/// @p text in letters that every file system takes: A-Z a-z 0-9 . and _; umlauts are spelled out, blanks and
/// everything else become _. At most 60 characters; empty only where nothing of it is left.
[[nodiscard]] std::string fileNamePart(std::string_view text);

/// "RoboCup2013-Team-Mission": the name that all files of a hand-in begin with. What is empty is named for
/// what it is.
[[nodiscard]] std::string handInName(std::string_view competition, std::string_view team,
                                     std::string_view mission);

}  // namespace leitstand
