#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/relaxation/closed_map.h"

namespace leitstand {

/// Reads what people know about pairs of scans, one pair per line. "i j tx ty tz qx qy qz qw" gives the pose
/// of scan j in the frame of scan i [m]. "i j no" says that the two scans do not see the same place. Scans
/// are numbered from 0. Blank lines and comments ('#') are skipped. Error when the length of a quaternion
/// differs from 1 by more than 1 %.
[[nodiscard]] Result<std::vector<GivenLink>> readGivenLinks(const std::filesystem::path& file);

}  // namespace leitstand
