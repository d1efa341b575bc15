#pragma once

#include <filesystem>
#include <limits>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// A scan and where it lies in the map.
struct PlacedScan {
    ScanPtr scan;
    Pose poseInMap = Pose::Identity();
};

/// Which points of a scan belong into a cloud of the map.
struct CloudRange {
    double min = 0.0;                                      ///< from the sensor on [m]
    double max = std::numeric_limits<double>::infinity();  ///< up to here [m]
};

/// Writes a map by @p out's ending. That of a CloudFormat: one cloud in map coordinates of all points in
/// @p range with an echo, with labels, and with intensities when all scans have them. A folder
/// (ends in "/", or is one): uos scans scan000.3d, ... with all their points, their poses in the map as .pose
/// and as .frames; a folder that holds further scans is an error.
[[nodiscard]] Result<void> writeMapCloud(const std::filesystem::path& out,
                                         const std::vector<PlacedScan>& scans, const CloudRange& range = {});

}  // namespace leitstand
