#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

/// Returns @p text in characters that every file system accepts: A-Z a-z 0-9 . and _. Umlauts are spelled
/// out. Each run of other characters becomes one _, and _ and . are removed from both ends. At most 61
/// characters; empty when nothing remains.
[[nodiscard]] std::string fileNamePart(std::string_view text);

/// Returns fileNamePart() of each of @p names, made unique; "robot" if that is empty. A repeated name gets
/// _2, _3 and so on at its end. Upper and lower case are treated as equal, because some file systems ignore
/// the difference.
[[nodiscard]] std::vector<std::string> fileNameParts(const std::vector<std::string>& names);

/// Returns the beginning of the names of all files of a hand-in: "RoboCup2013-Team-Mission". An empty part
/// becomes "Competition", "Team" or "Mission".
[[nodiscard]] std::string handInName(std::string_view competition, std::string_view team,
                                     std::string_view mission);

}  // namespace leitstand
