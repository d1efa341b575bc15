#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/services/log/live_mission.h"
#include "core/base/result.h"
#include "core/event/scan_links.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/mission_state.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A mission that has ended, as a station of ours recorded it: for what works on its map.
struct RecordedMap {
    std::filesystem::path folder;
    std::unique_ptr<BagReader> bag;
    std::vector<RobotDescription> robots;
    MissionState state;  ///< at its end
};

/// Reads the mission @p folder. Errors name it: it is no mission, or others recorded it.
[[nodiscard]] Result<RecordedMap> readMap(const std::filesystem::path& folder);

/// A session of @p map's mission, to write into, with the title, station and version of @p settings. Errors:
/// the mission cannot be written, or somebody wrote into it since it was read.
[[nodiscard]] Result<std::unique_ptr<LiveMission>> openAgain(const RecordedMap& map,
                                                             LiveMissionSettings settings,
                                                             LiveMissionListener listener = {});

/// The links of @p map as they are now, by rising id.
[[nodiscard]] std::vector<Link> linksOf(const RecordedMap& map);

}  // namespace leitstand
