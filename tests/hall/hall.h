#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand::test {

/// The three scans of the hall, labelled. Throws when they cannot be read.
[[nodiscard]] std::vector<ScanPtr> hallScans(const std::filesystem::path& folder);

/// Where the odometry puts scan @p i + 1 in scan @p i.
[[nodiscard]] Pose odometryStep(const std::vector<ScanPtr>& scans, std::size_t i);

/// A pose from the rows of its 3x4 matrix.
[[nodiscard]] Pose poseFromRows(const std::array<double, 12>& rows);

}  // namespace leitstand::test
