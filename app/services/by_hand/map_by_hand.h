#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/services/station/station_mapping.h"
#include "core/base/result.h"
#include "core/mission/state/mission_state.h"
#include "core/robot/robot_description.h"

namespace leitstand {

class LiveMission;

/// The map of a mission that has ended, for decisions of an operator as on a live map. The operator can move
/// parts of the map, answer loop closures, and accept, reject or register scans again. The decisions are
/// recorded in a new session of the mission. Earlier records are not changed, and each decision can be
/// undone. Any thread.
class MapByHand {
public:
    /// Opens the mission @p folder. @p station: who makes the decisions; begins with @ref MapByHandStation.
    /// Errors name the folder: others recorded it, it has no map, links of its scans are missing, or it
    /// cannot be written.
    [[nodiscard]] static Result<std::unique_ptr<MapByHand>> open(const std::filesystem::path& folder,
                                                                 const std::string& station,
                                                                 const std::string& version,
                                                                 StationMappingListener listener = {});
    ~MapByHand();  ///< does the same as close()
    MapByHand(const MapByHand&) = delete;
    MapByHand& operator=(const MapByHand&) = delete;

    [[nodiscard]] StationMapping& mapping() { return *m_mapping; }
    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_robots; }
    [[nodiscard]] MissionStatePtr state() const;
    /// Whether any decision was recorded since open().
    [[nodiscard]] bool decided() const;

    /// Waits until the map follows the decisions and the log has the result, then ends the session. Error
    /// when the log cannot be written.
    Result<void> close();

private:
    MapByHand(std::filesystem::path folder, std::vector<RobotDescription> robots);

    const std::filesystem::path m_folder;
    const std::vector<RobotDescription> m_robots;
    std::atomic<StationMapping*> m_listening = nullptr;  ///< called with what is logged
    std::unique_ptr<LiveMission> m_mission;
    std::unique_ptr<StationMapping> m_mapping;  ///< the last member, since it writes to the mission's log
    std::uint64_t m_before = 0;                 ///< sequence of the mission's last event before it was opened
};

}  // namespace leitstand
