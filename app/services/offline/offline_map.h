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
    MapScan scan;  ///< its poses are in the map's frame
    Pose sensorInBase = Pose::Identity();
    ScanArrival arrival;
};

/// A map of a mission that no station mapped. Its frame is level by odometry. The x and y of its origin are
/// where the robot of the first scan stood.
struct OfflineMap {
    std::vector<OfflineScan> scans;     ///< in the order they were registered
    std::size_t read = 0;               ///< scans that the mission holds; the above are a choice of them
    std::vector<std::string> warnings;  ///< as of MissionScans
};

/// Registers the clouds of @p mission, one every 0.3 m or 10 degrees as in a live map, by odometry where
/// there is any. Errors as of readMissionScans(). When cancelled, returns what was registered so far.
[[nodiscard]] Result<OfflineMap> mapOffline(const std::filesystem::path& mission,
                                            const Progress& progress = {});

}  // namespace leitstand
