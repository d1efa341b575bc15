#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/scan.h"
#include "core/registration/icp.h"

namespace leitstand {

/// A scan and its pose. Corrections move the pose, never the points.
struct MapScan {
    ScanPtr scan;                        ///< labelled
    Pose poseInMap = Pose::Identity();   ///< pose after registration
    Pose guessInMap = Pose::Identity();  ///< pose before registration
    std::size_t pointsUsed = 0;          ///< number of points after range limits, filter and voxel grid
    std::array<std::size_t, LabelCount> labelCounts{};  ///< number of points with each Label
    bool registered = false;  ///< false for the first scan, which defines the map's frame
    IcpResult icp;            ///< result of the alignment; meaningless unless `registered`
    double seconds = 0.0;     ///< time for preparing and aligning, wall clock [s]
    std::uint64_t id = 0;     ///< KeyScanSample::id in a live map; 0: none
    Time entered{};           ///< when it entered a live map, station's clock; epoch in other maps
    bool uncertain = false;   ///< it does not fit: it is shown, but nothing is built on it
};

/// Scans in the frame of the first scan. Immutable once shared.
struct Map {
    std::vector<MapScan> scans;
};
using MapPtr = std::shared_ptr<const Map>;

}  // namespace leitstand
