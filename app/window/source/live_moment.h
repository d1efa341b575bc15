#pragma once

#include <chrono>
#include <map>
#include <string>

#include "core/base/time.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mission/state/mission_state.h"
#include "core/station/robot_view.h"

namespace leitstand {

/// The state of everything at one moment. It is collected once and shown by all panes.
struct LiveMoment {
    Time now = {};  ///< the station's clock
    std::chrono::steady_clock::time_point steady = {};
    MissionStatePtr mission;
    RobotsInMapPtr places;                    ///< where robots are in the map
    LiveMapPtr scans;                         ///< key scans of the map
    std::map<std::string, RobotView> robots;  ///< by name; only the selected robot has surroundings

    [[nodiscard]] const RobotView& view(const std::string& robot) const;  ///< empty: unknown robot
    /// Empty: the robot sent nothing.
    [[nodiscard]] const RobotState& reported(const std::string& robot) const;
};

}  // namespace leitstand
