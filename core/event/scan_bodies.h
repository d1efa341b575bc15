#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// Where another robot was, or may have been, at a moment of a key scan.
struct BodyInScan {
    std::string robot;
    std::vector<Eigen::Vector2d> footprint;  ///< of that robot, its base frame, counter-clockwise [m]
    double height = 0.0;                     ///< of that robot [m]
    Pose baseInScan = Pose::Identity();      ///< in the frame of the scan's points
    double margin = 0.0;                     ///< how far the robot may be from baseInScan [m]
    friend bool operator==(const BodyInScan& a, const BodyInScan& b) {
        return a.robot == b.robot && a.footprint == b.footprint && a.height == b.height &&
               a.baseInScan.matrix() == b.baseInScan.matrix() && a.margin == b.margin;
    }
};

/// Other robots among the points of a key scan; they do not belong in the map.
struct BodiesOfScan {
    std::uint64_t scan = 0;          ///< KeyScanSample::id
    std::vector<BodyInScan> bodies;  ///< all that are known; empty: no robot is in the scan after all
};

/// Other robots in key scans. Replaces all that was known of these scans before: a robot may be placed long
/// after it was scanned.
struct ScanBodiesSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::vector<BodiesOfScan> scans;
};

}  // namespace leitstand
