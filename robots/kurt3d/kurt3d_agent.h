#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/perception/virtual_scan.h"
#include "robots/agent/odometry_track.h"
#include "robots/agent/robot_agent.h"
#include "robots/control/driving/explorer.h"
#include "robots/control/driving/victim_approach.h"
#include "robots/control/link_trail.h"
#include "robots/control/safe_teleoperation.h"

namespace leitstand {

/// How Kurt3D drives.
struct Kurt3dSettings {
    AgentSettings agent = {.geometry = {.trackWidth = 0.27 / 0.75, .maxSpeed = 0.6},  // turns slip by 25 %
                           .motors = {.fullSpeed = 0.64},
                           .modes = {DriveMode::Teleoperation, DriveMode::SafeTeleoperation,
                                     DriveMode::Explore, DriveMode::VictimApproach},
                           .hasRemote = false};
    std::chrono::nanoseconds thinks = std::chrono::milliseconds(50);  ///< period of its own drivers
    double lookAside = degrees(70);  ///< while exploring, it looks for heat so far to each side [rad]
    double lookRate = degrees(25);   ///< so fast [rad/s]
};

/// What drives Kurt3D: by its operator, by its operator with the virtual scan's limits, or by itself with
/// fuzzy control, up to victims (paper, section 2.3). One thread.
class Kurt3dAgent final : public RobotAgent {
public:
    /// @p fuzzy: rules of resources/control/fuzzy_drive.yaml. Errors as of FuzzyDrive::create().
    [[nodiscard]] static Result<std::unique_ptr<Kurt3dAgent>> create(RobotHardware& hardware,
                                                                     const RobotDescription& robot,
                                                                     const FuzzySystem& fuzzy,
                                                                     const Kurt3dSettings& settings = {});

private:
    Kurt3dAgent(RobotHardware& hardware, const RobotDescription& robot, const FuzzyDrive& drive,
                const Kurt3dSettings& settings);
    void sense(HardwareSample& sample) override;
    Report report(Time now) override;
    void goTo(const PoseSample& goal) override;
    DriveVelocity steer(const ModeDecision& decision, const DriveVelocity& wish, Time now) override;

    void see(const HardwareSample& sample, const PictureSample& picture);
    void lookForHeat(Driver driver, Time now);
    DriveVelocity think(const ModeDecision& decision, Time now);
    DriveVelocity explore(const std::optional<Eigen::Vector2d>& goal, Time now);
    DriveVelocity approach(Time now);
    [[nodiscard]] std::optional<Pose> inBase(const std::string& frame, const std::string& sensor) const;

    Kurt3dSettings m_settings;
    SafeTeleoperationSettings m_safety;
    VirtualScan m_scan;
    Explorer m_explorer;
    VictimApproach m_approach;
    LinkTrail m_trail;
    OdometryTrack m_odometry;
    std::map<std::string, std::pair<std::string, Pose>> m_frames;  ///< child: parent, child in it
    std::map<std::string, CameraInfoSample> m_cameras;             ///< by sensor
    VirtualScanView m_view;
    std::vector<HeatCue> m_cues;            ///< of the newest picture with a body in it
    std::optional<HeatCue> m_cue;           ///< that matters
    std::optional<Eigen::Vector2d> m_goal;  ///< of the operator, odom [m]
    std::optional<Time> m_thought;
    Driver m_before = Driver::Nobody;
    bool m_looks = false;      ///< it has turned the cameras by itself
    DriveVelocity m_velocity;  ///< of its own drivers
    Report m_report;
    std::size_t m_sightings = 0;  ///< that were said
};

}  // namespace leitstand
