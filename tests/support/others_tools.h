#pragma once

#include <filesystem>

#include "tests/support/missing_tool.h"
#include "tests/support/process.h"

namespace leitstand::test {

// Programs that we did not write read what we wrote. Tests ask LEITSTAND_NEEDS whether they could.
[[nodiscard]] ProcessOutcome readByGdal(const std::filesystem::path& map);      ///< gdalinfo
[[nodiscard]] ProcessOutcome readByOctomap(const std::filesystem::path& tree);  ///< bt2vrml; a .wrl beside it
[[nodiscard]] ProcessOutcome readByPoppler(const std::filesystem::path& pages);  ///< pdftotext
/// pcl_ply2pcd, which tells points and dimensions; @p pcd is written.
[[nodiscard]] ProcessOutcome readByPcl(const std::filesystem::path& ply, const std::filesystem::path& pcd);
/// A reader of rosbag2 files of npm, which decodes every message of @p mission, a folder with one log file.
[[nodiscard]] ProcessOutcome readByNpm(const std::filesystem::path& mission);

}  // namespace leitstand::test
