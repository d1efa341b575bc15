#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/services/mapping/robot_sight.h"
#include "app/services/station/lines/robot_calls.h"
#include "core/base/result.h"
#include "core/robot/joints/joint_control.h"
#include "core/robot/robot_description.h"
#include "transport/link/drive_streamer.h"
#include "transport/link/link_client.h"
#include "transport/services/navigation_client.h"

namespace leitstand {

/// A station's connection to one robot: it monitors the link, sends drive commands, and publishes the robot's
/// other commands. Any thread.
class RobotLine {
public:
    /// Callbacks of the line's streamer (DriveStreamerSettings).
    struct Driving {
        std::function<DriveConditions()> conditions;
        std::function<void(const GuardPulse&)> onPulse;
    };
    struct Listener {
        LinkListener link;
        RobotCalls::Ended called;  ///< called when a call of the operator has ended
    };
    /// Opens the line. The line also takes the clock offset from each LinkListener::onStatus. Errors name the
    /// robot's topic.
    [[nodiscard]] static Result<std::unique_ptr<RobotLine>> create(Node& node, const RobotDescription& robot,
                                                                   const std::string& station,
                                                                   Driving driving, Listener listener);
    RobotLine(const RobotLine&) = delete;
    RobotLine& operator=(const RobotLine&) = delete;

    [[nodiscard]] const RobotDescription& robot() const { return m_robot; }
    /// What this station cannot call of the robot, and why: without permission, in a domain with keys.
    [[nodiscard]] const std::vector<std::string>& problems() const { return m_problems; }
    [[nodiscard]] LinkClient& link() { return *m_link; }
    [[nodiscard]] const LinkClient& link() const { return *m_link; }
    [[nodiscard]] RobotCalls& calls() { return *m_calls; }
    [[nodiscard]] RobotSight& sight() { return m_sight; }
    [[nodiscard]] const RobotSight& sight() const { return m_sight; }
    /// Null when the robot takes no drive commands.
    [[nodiscard]] DriveStreamer* drive() const { return m_drive.get(); }
    void fillView(RobotView& robot) const;  ///< fills link, drive, cameras and joints
    /// Publishes a command other than for driving and stopping. Error when the robot does not take such
    /// commands.
    Result<void> publish(StreamRole role, const Sample& command);
    /// Tells the joints of @p group @p setpoints. Errors: nothing commands that group, or it cannot be
    /// written.
    Result<void> moveJoints(const JointGroup& group, const JointSetpoints& setpoints);
    /// Sends the robot to @p goal: by the action of its navigation if that is offered, otherwise by its
    /// topic.
    Result<void> goTo(const PoseSample& goal);
    /// Asks the robot's navigation to give up its goal; does nothing if it has none.
    void cancelGoal();

private:
    RobotLine(const RobotDescription& robot) : m_robot(robot), m_sight(m_robot) {}
    Result<void> open(Node& node, const std::string& station, Driving driving, Listener listener);

    struct Command {
        std::string type;
        std::unique_ptr<Publisher> publisher;
    };
    const RobotDescription m_robot;
    RobotSight m_sight;
    std::atomic<bool> m_linkLost = false;
    std::atomic<std::int64_t> m_clockAhead = 0;  ///< robot's clock minus station's clock [ns]
    std::map<StreamRole, Command> m_commands;
    std::map<std::string, Command> m_joints;  ///< by group
    std::vector<std::string> m_problems;
    std::unique_ptr<RobotCalls> m_calls;
    std::unique_ptr<LinkClient> m_link;
    std::unique_ptr<DriveStreamer> m_drive;
    std::unique_ptr<NavigationClient> m_navigation;  ///< null: the robot's file names none
};

}  // namespace leitstand
