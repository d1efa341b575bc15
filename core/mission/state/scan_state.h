#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/scan_pose.h"

namespace leitstand {

/// The decision that added a key scan, without its points, which stay in the log.
struct KeyScanEntry {
    std::uint64_t id = 0;
    std::string robot;
    Time stamp{};                          ///< when it was added, station's clock
    Pose sensorInBase = Pose::Identity();  ///< pose at the end of the sweep
    Pose scanInMap = Pose::Identity();     ///< pose when it was added
    std::optional<Pose> sensorInOdom{};    ///< pose by odometry, at the end of the sweep
    std::uint64_t matched = 0;             ///< id of the scan that it was registered against; 0: none
    std::uint64_t points = 0;
};

/// A key scan with its present pose.
struct KeyScanState {
    std::uint64_t sequence = 0;  ///< sequence of the event that has its points
    KeyScanEntry entry;
    ScanPose pose;  ///< newest pose that is not undone
    /// Sequence of the event that set the pose; same as `sequence` if nothing moved it.
    std::uint64_t poseSequence = 0;
};

}  // namespace leitstand
