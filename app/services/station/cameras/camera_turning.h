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
#include "core/event/motion_samples.h"
#include "core/robot/control/grant_book.h"
#include "core/robot/control/pan_tilt.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct Event;

/// The present state of a camera that can be turned.
struct CameraTurn {
    PanTiltMount mount;
    /// Now: from the robot's joints; requested: kept until reached.
    std::optional<PanTiltAngles> now, requested;
    bool waiting = false;  ///< whether the station waits for the grant to turn cameras
    std::string heldBy;    ///< title of another station that has the grant; empty: none has it
};

/// Turns cameras of robots; cameras on the same pan-tilt unit turn together. Requests the grant to turn
/// cameras when it is first used. Gives it to a station that requests it, if the cameras have not been used
/// for 10 s. While nobody has this grant, the holder of the grant to drive may turn cameras, too
/// (RobotAgent). Any thread; no call waits for the network.
class CameraTurning : public EventSink {
public:
    /// Functions of the station that it uses.
    struct Wire {
        std::function<GrantView(const GrantId&)> grant;
        std::function<bool(const GrantId&)> mayAct;
        std::function<void(const GrantId&)> ask;
        std::function<void(const GrantId&, bool consent)> answer;
        std::function<Result<void>(const std::string& robot, const PanTiltCommand& command)> send;
    };
    CameraTurning(const std::vector<RobotDescription>& robots, Wire wire);

    void onEvent(const Event& event) override;  ///< takes joint states; ignores other events
    /// Returns the state of a camera; empty when @p sensor of @p robot cannot be turned.
    [[nodiscard]] std::optional<CameraTurn> view(const std::string& robot, const std::string& sensor) const;

    // Requests of the operator; without effect on what cannot be turned.
    void turnTo(const std::string& robot, const std::string& sensor, const PanTiltAngles& angles);
    void turnBy(const std::string& robot, const std::string& sensor, const PanTiltAngles& step);
    /// Turns by @p perSecond [rad/s] until another rate is set.
    void setRate(const std::string& robot, const std::string& sensor, const PanTiltAngles& perSecond);
    void recentre(const std::string& robot);  ///< recentres all cameras of the robot

    /// Sends what is due. Call about 30 times a second. Returns an error once for each request of the
    /// operator.
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
        bool failed = false;  ///< whether the error was reported already
    };
    std::map<std::string, Use> m_uses;  ///< by robot
};

}  // namespace leitstand
