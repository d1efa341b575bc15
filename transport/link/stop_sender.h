#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/control/stop/stop_control.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// How a station stops robots.
struct StopSenderSettings {
    std::string station = "leitstand";  ///< the station's persistent identity
    /// Returns whether this station holds the grant to drive a robot (GrantKeeper::mayAct). Empty: it may
    /// release no robot.
    std::function<bool(const std::string& robot)> mayRelease = {};
    /// Called when the status() of a robot has changed, on the sender's own thread. No lock is held, so it
    /// may call the sender, but not destroy it.
    std::function<void(const std::string& robot)> onChange = {};
    StopTiming timing = {};
};

/// STOP over DDS (StopControl): stops any robot, repeats each stop until the robot has acknowledged it, and
/// reports the state of each robot. Only releases need the grant, so viewers may have a StopSender, too. It
/// sends nothing to robots without a stop_command; DriveStreamer holds those with zeros. A robot's stop_lock
/// is set ten times a second while a stop of this station is in force, and freed by the release; that fails
/// or waits for nothing else. Any thread; nothing waits for the network or anything else.
class StopSender {
public:
    /// Errors name the topic (wrong type, or the node may not use it), or say that two robots have the same
    /// name.
    [[nodiscard]] static Result<std::unique_ptr<StopSender>> create(Node& node,
                                                                    std::span<const RobotDescription> robots,
                                                                    StopSenderSettings settings = {});
    ~StopSender();
    StopSender(const StopSender&) = delete;
    StopSender& operator=(const StopSender&) = delete;

    void stopAll();
    void stop(const std::string& robot);  ///< does nothing for unknown names
    /// Releases @p robot from its stop. Errors are those of StopControl::release(), or that there is no robot
    /// with this name.
    Result<void> release(const std::string& robot);

    [[nodiscard]] StopStatus status(const std::string& robot) const;
    /// For DriveConditions::mayDrive: returns whether no stop of the robot is in force. False for unknown
    /// names.
    [[nodiscard]] bool allowsDriving(const std::string& robot) const;
    /// For DriveConditions::hold: returns whether the robot must be stopped but takes no stop commands, so
    /// that zeros must hold it.
    [[nodiscard]] bool holdsByZeros(const std::string& robot) const;

private:
    struct State;
    explicit StopSender(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
