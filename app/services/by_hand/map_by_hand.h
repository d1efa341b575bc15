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

/// The map of a mission that has ended, on which an operator decides as on a live one. The operator moves
/// parts of it, answers where it meets itself, and accepts, rejects and registers scans again. A session of
/// the mission records the decisions. What was recorded before stays as it is, and each decision can be taken
/// back. Any thread.
class MapByHand {
public:
    /// Opens the mission @p folder. @p station is the name of who decides; it begins with
    /// @ref MapByHandStation. Errors name the folder: it is no mission of ours, has no map, or cannot be
    /// written.
    [[nodiscard]] static Result<std::unique_ptr<MapByHand>> open(const std::filesystem::path& folder,
                                                                 const std::string& station,
                                                                 const std::string& version,
                                                                 StationMappingListener listener = {});
    ~MapByHand();  ///< as close()
    MapByHand(const MapByHand&) = delete;
    MapByHand& operator=(const MapByHand&) = delete;

    [[nodiscard]] StationMapping& mapping() { return *m_mapping; }
    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_robots; }
    [[nodiscard]] MissionStatePtr state() const;
    /// Whether anything has been decided here.
    [[nodiscard]] bool decided() const;

    /// Waits until the map follows the decisions and the log holds all of that, then ends. Error when the log
    /// cannot be written.
    Result<void> close();

private:
    MapByHand(std::filesystem::path folder, std::vector<RobotDescription> robots);

    const std::filesystem::path m_folder;
    const std::vector<RobotDescription> m_robots;
    std::atomic<StationMapping*> m_listening = nullptr;  ///< receives what is logged
    std::unique_ptr<LiveMission> m_mission;
    std::unique_ptr<StationMapping> m_mapping;  ///< last: it logs into the mission
    std::uint64_t m_before = 0;                 ///< sequence number of the mission when it was opened
};

}  // namespace leitstand
