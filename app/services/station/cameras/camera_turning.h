#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/services/log/event_sink.h"
#include "core/base/result.h"
#include "core/event/event.h"
#include "core/robot/control/grant_book.h"
#include "core/robot/control/pan_tilt.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A camera that can be turned, as the station has it now.
struct CameraTurn {
    PanTiltMount mount;
    std::optional<PanTiltAngles> now, wish;  ///< now: as the robot's joints say; wish: while it is on its way
    bool waiting = false;                    ///< for the grant to turn cameras
    std::string heldBy;                      ///< another station that has the grant, for people; empty: none
};

/// Turns cameras of robots: cameras of one pan-tilt unit turn together. Asks for the grant when it is first
/// used, and leaves it to a station that asks once they were left alone for 10 s; until anybody has it, who
/// holds the grant to drive turns cameras, too (RobotAgent). Any thread; nothing waits for the network.
class CameraTurning : public EventSink {
public:
    /// What it needs of its station.
    struct Wire {
        std::function<GrantView(const GrantId&)> grant;
        std::function<bool(const GrantId&)> mayAct;
        std::function<void(const GrantId&)> ask;
        std::function<void(const GrantId&, bool consent)> answer;
        std::function<Result<void>(const std::string& robot, const PanTiltCommand& command)> send;
    };
    CameraTurning(const std::vector<RobotDescription>& robots, Wire wire);

    void onEvent(const Event& event) override;  ///< joint states; others are passed by
    /// Empty when @p sensor of @p robot cannot be turned.
    [[nodiscard]] std::optional<CameraTurn> view(const std::string& robot, const std::string& sensor) const;

    // What the operator wants; nothing for what cannot be turned.
    void turnTo(const std::string& robot, const std::string& sensor, const PanTiltAngles& angles);
    void turnBy(const std::string& robot, const std::string& sensor, const PanTiltAngles& step);
    /// On and on, until told otherwise [rad/s].
    void setRate(const std::string& robot, const std::string& sensor, const PanTiltAngles& perSecond);
    void recentre(const std::string& robot);  ///< all of its cameras

    /// Sends what is due; to be called about 30 times a second. The error is told once for each wish.
    [[nodiscard]] Result<void> pulse();

private:
    using Unit = std::pair<std::string, std::string>;  ///< robot, unit
    [[nodiscard]] PanTiltControl* find(const std::string& robot, const std::string& sensor);
    void want(const std::string& robot);
    [[nodiscard]] bool maySend(const std::string& robot) const;
    void answer();

    const Wire m_wire;
    mutable std::mutex m_mutex;
    std::map<Unit, PanTiltControl> m_units;
    std::map<std::pair<std::string, std::string>, std::string> m_unitOf;  ///< by robot and sensor
    struct Use {
        SteadyTime last = {};
        bool failed = false;  ///< told already
    };
    std::map<std::string, Use> m_uses;  ///< by robot
};

}  // namespace leitstand
