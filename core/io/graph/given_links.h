#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/relaxation/closed_map.h"

namespace leitstand {

/// Reads what somebody says of two scans each, a line: "i j tx ty tz qx qy qz qw", where scan j is in the
/// frame of scan i [m], or "i j no" where they do not see the same place. Scans are numbered from 0. Blank
/// lines and comments ('#') are left out. A quaternion whose length is not 1 within 1 % is an error.
[[nodiscard]] Result<std::vector<GivenLink>> readGivenLinks(const std::filesystem::path& file);

}  // namespace leitstand
