#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// Where another robot was, or may have been, while a key scan was taken.
struct BodyInScan {
    std::string robot;
    /// Outline of that robot in its base frame, counter-clockwise [m].
    std::vector<Eigen::Vector2d> footprint;
    double height = 0.0;                 ///< height of that robot [m]
    Pose baseInScan = Pose::Identity();  ///< in the frame of the scan's points
    double margin = 0.0;                 ///< largest distance of the robot from baseInScan [m]
    friend bool operator==(const BodyInScan& a, const BodyInScan& b) {
        return a.robot == b.robot && a.footprint == b.footprint && a.height == b.height &&
               a.baseInScan.matrix() == b.baseInScan.matrix() && a.margin == b.margin;
    }
};

/// Other robots whose points are in a key scan. They do not belong to the map.
struct BodiesOfScan {
    std::uint64_t scan = 0;          ///< KeyScanSample::id
    std::vector<BodyInScan> bodies;  ///< all known bodies; empty: there is no robot in the scan
};

/// Other robots in key scans. Replaces everything that was known about these scans, since a robot may be
/// placed long after it was scanned.
struct ScanBodiesSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::vector<BodiesOfScan> scans;
};

}  // namespace leitstand
