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
    std::string station = "leitstand";  ///< persistent identity
    /// Returns whether this station holds the grant to drive a robot (GrantKeeper::mayAct); none: it releases
    /// nothing.
    std::function<bool(const std::string& robot)> mayRelease = {};
    /// Called when the status() of a robot has changed, on the sender's own thread, without a lock held. May
    /// call the sender, but not destroy it.
    std::function<void(const std::string& robot)> onChange = {};
    StopTiming timing = {};
};

/// STOP over DDS (StopControl): stops any of the robots, repeats each stop until the robot has acknowledged
/// it, and reports the state of each. Only releases need the grant, so viewers may have a StopSender, too. To
/// robots without a stop_command it sends nothing: DriveStreamer holds them by zeros. Any thread; nothing
/// waits for the network or anybody else.
class StopSender {
public:
    /// Errors name the topic: its type is wrong, or the node may not use it. Or two robots have one name.
    [[nodiscard]] static Result<std::unique_ptr<StopSender>> create(Node& node,
                                                                    std::span<const RobotDescription> robots,
                                                                    StopSenderSettings settings = {});
    ~StopSender();
    StopSender(const StopSender&) = delete;
    StopSender& operator=(const StopSender&) = delete;

    void stopAll();
    void stop(const std::string& robot);  ///< does nothing for unknown names
    /// Releases @p robot from its stop. Errors: as of StopControl::release(), or there is no robot of that
    /// name.
    Result<void> release(const std::string& robot);

    [[nodiscard]] StopStatus status(const std::string& robot) const;
    /// For DriveConditions::mayDrive. Returns whether no stop of the robot stands; false for unknown names.
    [[nodiscard]] bool allowsDriving(const std::string& robot) const;
    /// For DriveConditions::hold. Returns whether the robot is to stop but takes no stop commands: zeros must
    /// hold it.
    [[nodiscard]] bool holdsByZeros(const std::string& robot) const;

private:
    struct State;
    explicit StopSender(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
