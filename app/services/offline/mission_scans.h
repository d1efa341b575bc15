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

/// The scans that a mission holds, in order of their stamps.
struct MissionScans {
    std::vector<ScanPtr> scans;
    std::vector<Pose> sensorsInBase;    ///< pose of each scan's sensor at the end of the sweep
    std::vector<ScanArrival> arrivals;  ///< of each scan
    std::vector<std::string> warnings;  ///< what could not be read or is missing; each names its location
};

/// Whether @p path is a mission: a rosbag2 folder or a file of one.
[[nodiscard]] bool isMission(const std::filesystem::path& path);

/// Returns the scans of @p mission: its robots' clouds, with the pose of the sensor by odometry, tf_static
/// and the robot's file. Robots are those that the folder keeps, else those guessed from the topics of a
/// foreign bag. Error when the bag cannot be opened or holds no clouds. When cancelled, returns what was read
/// so far.
[[nodiscard]] Result<MissionScans> readMissionScans(const std::filesystem::path& mission,
                                                    const Progress& progress = {});

}  // namespace leitstand
