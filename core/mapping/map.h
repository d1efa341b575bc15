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

/// A scan with its one pose: corrections move the pose, never the points.
struct MapScan {
    ScanPtr scan;                                       ///< labelled
    Pose poseInMap = Pose::Identity();                  ///< after registration
    Pose guessInMap = Pose::Identity();                 ///< before registration
    std::size_t pointsUsed = 0;                         ///< after range limits, filter and voxel grid
    std::array<std::size_t, LabelCount> labelCounts{};  ///< points of the scan per Label
    bool registered = false;  ///< false for the first scan, which defines the map's frame
    IcpResult icp;            ///< of the alignment; meaningless unless registered
    double seconds = 0.0;     ///< preparing and aligning, wall clock [s]
    std::uint64_t id = 0;     ///< KeyScanSample::id of a live map; 0: none
    Time entered{};           ///< of a live map: when it entered, station's clock; else epoch
    bool uncertain = false;   ///< it does not fit: it is shown, but nothing is built on it
};

/// Scans in the frame of the first one. Immutable once shared.
struct Map {
    std::vector<MapScan> scans;
};
using MapPtr = std::shared_ptr<const Map>;

}  // namespace leitstand
