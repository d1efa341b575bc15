#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// @p text in letters that every file system takes: A-Z a-z 0-9 . and _; umlauts are spelled out, blanks and
/// everything else become _. At most 60 characters; empty only where nothing of it is left.
[[nodiscard]] std::string fileNamePart(std::string_view text);

/// @p names as fileNamePart() has them, told apart: what nothing is left of is "robot", and one that an
/// earlier name has (also in other capitals, which some file systems take for the same) ends in _2, _3 and so
/// on.
[[nodiscard]] std::vector<std::string> fileNameParts(const std::vector<std::string>& names);

/// "RoboCup2013-Team-Mission": the name that all files of a hand-in begin with. What is empty is named for
/// what it is.
[[nodiscard]] std::string handInName(std::string_view competition, std::string_view team,
                                     std::string_view mission);

}  // namespace leitstand
