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

/// A scan in the live map. Its points never change, but its pose may.
struct LiveKeyScan {
    std::uint64_t id = 0;  ///< KeyScanSample::id
    ScanPtr scan;          ///< labelled and reduced, without the robot's own body and points outside the area
    /// All points, also those outside the area; may be null while none was removed.
    std::shared_ptr<KeptScan> kept;
    Pose sensorInBase = Pose::Identity();
    ScanPose pose;                      ///< pose with trust and doubts
    std::uint64_t matched = 0;          ///< id of the nearest scan that it was registered against; 0: none
    Pose enteredAt = Pose::Identity();  ///< KeyScanSample::scanInMap
    /// Id of the scan that begins this scan's part of the map, if the part's pose relative to the first part
    /// is unknown. 0: the scan belongs to the first part, or to one that is joined with it.
    std::uint64_t part = 0;
    Time entered{};                     ///< when it entered, station's clock; different for each scan
    std::optional<Eigen::Vector3d> up;  ///< upward direction in the scan's frame; empty: unknown
    int odometryFrame = -1;   ///< number of its odometry; negative: from an earlier run of the station
    MatchedCloudPtr reduced;  ///< cloud with normals for registration, in the scan's frame
    /// Unspun * pose by odometry = that pose without the earlier spinning of wheels in this run.
    Pose unspun = Pose::Identity();

    [[nodiscard]] bool counts() const { return pose.trust == ScanTrust::Certain; }
    /// Returns whether the scan begins a part of the map: beginsPart().
    [[nodiscard]] bool begins() const { return beginsPart(matched, pose.doubts); }
    /// Returns the scan's pose by odometry, without the spinning of wheels. Use only the motion between two
    /// such poses of the same odometry frame.
    [[nodiscard]] Pose sensorByWheels() const { return unspun * scan->sensorInOdom; }
};

/// A snapshot of the live map: immutable once shared.
struct LiveMap {
    std::vector<LiveKeyScan> scans;  ///< by rising id
};
using LiveMapPtr = std::shared_ptr<const LiveMap>;

/// Returns whether @p map has a part with valid scans that is not joined with its first part.
[[nodiscard]] inline bool inParts(const LiveMap& map) {
    return std::any_of(map.scans.begin(), map.scans.end(),
                       [](const LiveKeyScan& scan) { return scan.part != 0 && scan.counts(); });
}

}  // namespace leitstand
