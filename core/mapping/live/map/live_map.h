#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/scan.h"
#include "core/event/scan_pose.h"
#include "core/mapping/graph/map_parts.h"
#include "core/mapping/live/map/kept_scan.h"
#include "core/mapping/live/map/matched_clouds.h"

namespace leitstand {

/// A scan that entered the live map. Its points never change, its pose may.
struct LiveKeyScan {
    std::uint64_t id = 0;  ///< KeyScanSample::id
    ScanPtr scan;          ///< labelled, reduced, without the robot's own body and what is cropped now
    std::shared_ptr<KeptScan> kept;  ///< all its points, also cropped ones; may be null while none is cropped
    Pose sensorInBase = Pose::Identity();
    ScanPose pose;                      ///< with its trust and doubts
    std::uint64_t matched = 0;          ///< id of the nearest scan that it was registered against; 0: none
    Pose enteredAt = Pose::Identity();  ///< KeyScanSample::scanInMap
    /// Id of the scan with which its part of the map begins, if the pose of this part relative to the map's
    /// first part is unknown. 0: it is of the first part, or of one that has met the first.
    std::uint64_t part = 0;
    Time entered{};                     ///< station's clock; different for each scan
    std::optional<Eigen::Vector3d> up;  ///< against gravity, scan's frame; empty: unknown
    int odometryFrame = -1;          ///< number of its odometry; negative: of an earlier run of the station
    MatchedCloudPtr reduced;         ///< for registration, with normals; scan's frame
    Pose unspun = Pose::Identity();  ///< put before its pose by odometry, takes out how far wheels spun
                                     ///< before, in this run

    [[nodiscard]] bool counts() const { return pose.trust == ScanTrust::Certain; }
    /// Returns whether a part of the map begins with it: beginsPart().
    [[nodiscard]] bool begins() const { return beginsPart(matched, pose.doubts); }
    /// Returns its pose by odometry, with the spinning of wheels taken out. Use only the motion between two
    /// such poses of one odometry frame.
    [[nodiscard]] Pose sensorByWheels() const { return unspun * scan->sensorInOdom; }
};

/// The live map, a snapshot: immutable once shared.
struct LiveMap {
    std::vector<LiveKeyScan> scans;  ///< by rising id
};
using LiveMapPtr = std::shared_ptr<const LiveMap>;

/// Returns whether @p map has a part that has not met its first part yet, with scans that count.
[[nodiscard]] inline bool inParts(const LiveMap& map) {
    return std::any_of(map.scans.begin(), map.scans.end(),
                       [](const LiveKeyScan& scan) { return scan.part != 0 && scan.counts(); });
}

}  // namespace leitstand
