#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// Returns @p text in characters that every file system takes: A-Z a-z 0-9 . and _. Umlauts are spelled out;
/// blanks and everything else become _. At most 60 characters; empty only when nothing of it is left.
[[nodiscard]] std::string fileNamePart(std::string_view text);

/// Returns fileNamePart() of each of @p names, made unique. A name becomes "robot" when nothing of it is
/// left. A name that an earlier one has ends in _2, _3 and so on. Capitals do not count, because some file
/// systems ignore them.
[[nodiscard]] std::vector<std::string> fileNameParts(const std::vector<std::string>& names);

/// Returns the name that all files of a hand-in begin with: "RoboCup2013-Team-Mission". An empty part is
/// named for what it is.
[[nodiscard]] std::string handInName(std::string_view competition, std::string_view team,
                                     std::string_view mission);

}  // namespace leitstand
