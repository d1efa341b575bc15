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
    Time stamp{};                          ///< station's clock
    Pose sensorInBase = Pose::Identity();  ///< at the end of the sweep
    Pose scanInMap = Pose::Identity();     ///< when it was added
    std::optional<Pose> sensorInOdom{};    ///< by odometry, at the end of the sweep
    std::uint64_t matched = 0;             ///< id of the scan it was registered against; 0: none
    std::uint64_t points = 0;
};

/// A key scan and where it is now.
struct KeyScanState {
    std::uint64_t sequence = 0;  ///< of the event that has its points
    KeyScanEntry entry;
    ScanPose pose;                   ///< newest that is not undone
    std::uint64_t poseSequence = 0;  ///< of the event that set pose; same as sequence if nothing moved it
};

}  // namespace leitstand
