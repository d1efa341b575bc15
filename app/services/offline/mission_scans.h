#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cloud/scan.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// The event that completed a scan.
struct ScanArrival {
    std::uint64_t sequence = 0;
    Time received{};  ///< station's clock
};

/// The scans in a mission, in the order of their stamps.
struct MissionScans {
    std::vector<ScanPtr> scans;
    std::vector<Pose> sensorsInBase;    ///< pose in the base of each scan's sensor at the end of the sweep
    std::vector<ScanArrival> arrivals;  ///< one for each scan
    std::vector<std::string> warnings;  ///< what could not be read or is missing; each warning says where
};

/// Whether @p path is a mission: a rosbag2 folder or one of its files.
[[nodiscard]] bool isMission(const std::filesystem::path& path);

/// Returns the scans of @p mission: its robots' clouds, with the pose of the sensor from odometry, tf_static
/// and the robot's file. The robots are those kept in the folder; if there are none, they are guessed from
/// the topics of the bag. Error when the bag cannot be opened or has no clouds. When cancelled, returns what
/// was read so far.
[[nodiscard]] Result<MissionScans> readMissionScans(const std::filesystem::path& mission,
                                                    const Progress& progress = {});

}  // namespace leitstand
