#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// Returns @p text in characters that every file system takes: A-Z a-z 0-9 . and _. Umlauts are spelled out.
/// Each run of other characters becomes one _, and neither _ nor . is left at an end. At most 61 characters;
/// empty when nothing is left.
[[nodiscard]] std::string fileNamePart(std::string_view text);

/// Returns fileNamePart() of each of @p names, made unique; "robot" where that is empty. A repeated name gets
/// _2, _3 and so on at its end. Upper and lower case count as equal, because some file systems ignore the
/// difference.
[[nodiscard]] std::vector<std::string> fileNameParts(const std::vector<std::string>& names);

/// Returns the name with which all files of a hand-in begin: "RoboCup2013-Team-Mission". An empty part
/// becomes "Competition", "Team" or "Mission".
[[nodiscard]] std::string handInName(std::string_view competition, std::string_view team,
                                     std::string_view mission);

}  // namespace leitstand
