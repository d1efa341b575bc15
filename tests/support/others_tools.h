#pragma once

#include <filesystem>
#include <string>

#include "tests/support/missing_tool.h"
#include "tests/support/process.h"

namespace leitstand::test {

// Programs that we did not write read what we wrote. Tests ask LEITSTAND_NEEDS whether they could.
[[nodiscard]] ProcessOutcome readByGdal(const std::filesystem::path& map);  ///< gdalinfo
/// gdallocationinfo: what it prints is "R G B" of the pixel at x and y of our map [m].
[[nodiscard]] ProcessOutcome colourByGdal(const std::filesystem::path& map, double x, double y);
/// python3, which runs @p script with @p file as its argument.
[[nodiscard]] ProcessOutcome readByPython(const std::string& script, const std::filesystem::path& file);
/// sqlite3, which answers @p query of a copy of a log file: it moves a write-ahead log in.
[[nodiscard]] ProcessOutcome askBySqlite(const std::filesystem::path& log, const std::string& query);
[[nodiscard]] ProcessOutcome readByOctomap(const std::filesystem::path& tree);  ///< bt2vrml; a .wrl beside it
[[nodiscard]] ProcessOutcome readByPoppler(const std::filesystem::path& pages);  ///< pdftotext
/// pdftotext -bbox: every word and its place.
[[nodiscard]] ProcessOutcome boxesByPoppler(const std::filesystem::path& pages);
/// pcl_ply2pcd, which tells points and dimensions; @p pcd is written.
[[nodiscard]] ProcessOutcome readByPcl(const std::filesystem::path& ply, const std::filesystem::path& pcd);
/// A reader of rosbag2 files of npm, which decodes every message of @p mission, a folder with one log file.
[[nodiscard]] ProcessOutcome readByNpm(const std::filesystem::path& mission);

}  // namespace leitstand::test
