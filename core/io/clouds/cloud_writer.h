#pragma once

#include <filesystem>
#include <limits>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// A scan with its pose in the map.
struct PlacedScan {
    ScanPtr scan;
    Pose poseInMap = Pose::Identity();
};

/// Which points of a scan belong to the cloud of a map, by their distance from the sensor.
struct CloudRange {
    double min = 0.0;                                      ///< least distance [m]
    double max = std::numeric_limits<double>::infinity();  ///< largest distance [m]
};

/// Writes a map as one cloud, or as scans in a folder. If @p out has the ending of a CloudFormat, it becomes
/// one cloud in map coordinates, of all points in @p range that have an echo. That cloud has labels, and if
/// all scans have intensities, it has them too.
///
/// A folder (@p out ends in "/", or is a folder) gets uos scans scan000.3d, ... with all their points. Their
/// poses in the map are written as .pose and as .frames. Scans of an earlier map with the same numbers are
/// replaced; any other scan in the folder is an error.
[[nodiscard]] Result<void> writeMapCloud(const std::filesystem::path& out,
                                         const std::vector<PlacedScan>& scans, const CloudRange& range = {});

}  // namespace leitstand
