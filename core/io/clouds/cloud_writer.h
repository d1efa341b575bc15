#pragma once

#include <filesystem>
#include <limits>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// A scan and its pose in the map.
struct PlacedScan {
    ScanPtr scan;
    Pose poseInMap = Pose::Identity();
};

/// Range in which points of a scan belong to a cloud of the map.
struct CloudRange {
    double min = 0.0;                                      ///< distance from the sensor [m]
    double max = std::numeric_limits<double>::infinity();  ///< distance from the sensor [m]
};

/// Writes a map as one cloud, or as scans in a folder. If @p out has the ending of a CloudFormat, it becomes
/// one cloud in map coordinates, of all points in @p range with an echo. That cloud has labels, and
/// intensities when all scans have them. A folder (ends in "/", or is one) gets uos scans scan000.3d, ...
/// with all their points. Their poses in the map are written as .pose and as .frames. Scans of an earlier map
/// with the same numbers are replaced; any other scan in the folder is an error.
[[nodiscard]] Result<void> writeMapCloud(const std::filesystem::path& out,
                                         const std::vector<PlacedScan>& scans, const CloudRange& range = {});

}  // namespace leitstand
