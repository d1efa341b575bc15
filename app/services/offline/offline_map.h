#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/offline/mission_scans.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/map.h"

namespace leitstand {

/// A scan that was registered after the mission.
struct OfflineScan {
    MapScan scan;  ///< with poses in the map's frame
    Pose sensorInBase = Pose::Identity();
    ScanArrival arrival;
};

/// A map of a mission that no station mapped. Its frame is level according to odometry. The x and y of its
/// origin are those of the first scan's robot.
struct OfflineMap {
    std::vector<OfflineScan> scans;  ///< in the order in which they were registered
    std::size_t read = 0;            ///< number of scans in the mission, from which the above were selected
    std::vector<std::string> warnings;  ///< those of MissionScans
};

/// Registers the clouds of @p mission, one every 0.3 m or 10 degrees as in a live map. Starts from odometry
/// if there is any. Errors are those of readMissionScans(). When cancelled, returns what was registered so
/// far.
[[nodiscard]] Result<OfflineMap> mapOffline(const std::filesystem::path& mission,
                                            const Progress& progress = {});

}  // namespace leitstand
