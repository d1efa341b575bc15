#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/perception/surroundings/virtual_scan.h"
#include "robots/agent/odometry_track.h"
#include "robots/agent/robot_agent.h"
#include "robots/control/driving/explorer.h"
#include "robots/control/link_trail.h"

namespace leitstand {

struct PoseSample;

/// How a robot looks and drives by itself. The size of its body is set from its description.
struct SelfDrivingSettings {
    /// Period in which its own drivers decide.
    std::chrono::nanoseconds thinks = std::chrono::milliseconds(50);
    VirtualScanSettings scan;
    FuzzyDriveSettings drive;
    ExplorerSettings explorer;
};

/// Returns the settings of the virtual scan by which @p robot drives. The profile is that of profileOf(),
/// with at least the height in @p settings.
[[nodiscard]] VirtualScanSettings scanFor(const RobotDescription& robot, const SelfDrivingSettings& settings);

/// What robots that can drive by themselves have in common (paper, section 2.3). They have a virtual scan
/// from 3D or plane lasers and safe teleoperation. They explore, drive to a goal, and drive back to where the
/// link was good. One thread.
class SelfDrivingAgent : public RobotAgent {
protected:
    /// @p drive: result of driveFor().
    SelfDrivingAgent(RobotHardware& hardware, const RobotDescription& robot, const FuzzyDrive& drive,
                     const AgentSettings& agent, const SelfDrivingSettings& settings);
    /// Returns the fuzzy driver for @p robot. Errors are those of FuzzyDrive::create().
    [[nodiscard]] static Result<FuzzyDrive> driveFor(const RobotDescription& robot, const FuzzySystem& fuzzy,
                                                     const SelfDrivingSettings& settings);

    void sense(HardwareSample& sample) override;
    Report report(Time now) override;
    void goTo(const PoseSample& goal) override;
    DriveVelocity steer(const ModeDecision& decision, const DriveVelocity& requested, Time now) override;

    /// Called with each new view before it is used. Robots may add what they know about their surroundings.
    virtual void consider(VirtualScanView& view, const Pose& here, Time now);
    /// Returns the velocity that the robot's own driver wants at pose @p here. Also called while somebody
    /// else drives; then the robot only observes.
    virtual DriveVelocity think(const ModeDecision& decision, const Pose& here, Time now);
    virtual void thought(const ModeDecision& decision, Time now);  ///< called after every think()
    virtual void takeOver(Driver before, Driver now);  ///< called before the first think() of another driver
    [[nodiscard]] virtual double caution() const { return 1.0; }  ///< share of the speed, 0 to 1

    /// Returns the pose of @p frame in base_link, from the newest transforms. If there are none, from the
    /// description of @p sensor. Empty: unknown.
    [[nodiscard]] std::optional<Pose> inBase(const std::string& frame, const std::string& sensor) const;
    [[nodiscard]] const OdometryTrack& odometry() const { return m_odometry; }
    [[nodiscard]] const VirtualScanView& view() const { return m_view; }
    [[nodiscard]] const SafeTeleoperationSettings& safety() const { return m_safety; }
    /// Result of its last think().
    [[nodiscard]] const DriveVelocity& velocity() const { return m_velocity; }
    [[nodiscard]] Driver driver() const { return m_driver; }
    [[nodiscard]] bool hasGoal() const { return m_goal.has_value(); }  ///< whether the operator set a goal
    /// Returns the velocity for one step towards @p place in odom [m]. This is not reported to the modes.
    /// Empty: the robot has arrived, or finds no way.
    [[nodiscard]] std::optional<DriveVelocity> driveBy(const Eigen::Vector3d& place, const Pose& here,
                                                       Time now);
    Explorer& explorer() { return m_explorer; }
    Report& reported() { return m_report; }  ///< what will be reported to the modes

private:
    DriveVelocity explore(const std::optional<Eigen::Vector3d>& goal, const Pose& here, Time now);
    DriveVelocity comeBack(const Pose& here, Time now);
    [[nodiscard]] bool isDue(Time now) const { return !m_thought || now - *m_thought >= m_thinks; }

    std::chrono::nanoseconds m_thinks;
    SafeTeleoperationSettings m_safety;
    VirtualScan m_scan;
    Explorer m_explorer;
    LinkTrail m_trail;
    OdometryTrack m_odometry;
    /// Child -> parent, and pose of the child in the parent.
    std::map<std::string, std::pair<std::string, Pose>> m_frames;
    VirtualScanView m_view;
    std::optional<Eigen::Vector3d> m_goal;  ///< the operator's goal in odom [m]
    std::optional<Time> m_thought;
    Driver m_driver = Driver::Nobody;
    DriveVelocity m_velocity;
    Report m_report;
};

}  // namespace leitstand
