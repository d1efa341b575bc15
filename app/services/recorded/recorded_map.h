#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/services/log/live_mission.h"
#include "core/base/result.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/mission_state.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct Link;

/// A mission that has ended and was recorded by Leitstand, for work on its map.
struct RecordedMap {
    std::filesystem::path folder;
    std::unique_ptr<BagReader> bag;
    std::vector<RobotDescription> robots;
    MissionState state;  ///< state at its end
};

/// Reads the mission @p folder. Errors name the folder: it is no mission, or others recorded it.
[[nodiscard]] Result<RecordedMap> readMap(const std::filesystem::path& folder);

/// Opens a session for writing to the mission of @p map, with the title, station and version in @p settings.
/// Error when the mission cannot be written, or when somebody wrote to it since it was read.
[[nodiscard]] Result<std::unique_ptr<LiveMission>> openAgain(const RecordedMap& map,
                                                             LiveMissionSettings settings,
                                                             LiveMissionListener listener = {});

/// Returns the present links of @p map, by rising id.
[[nodiscard]] std::vector<Link> linksOf(const RecordedMap& map);

}  // namespace leitstand
