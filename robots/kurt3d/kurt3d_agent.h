#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/event/picture_samples.h"
#include "robots/agent/self_driving_agent.h"
#include "robots/control/driving/passed_heat.h"
#include "robots/control/driving/victim_approach.h"

namespace leitstand {

struct PictureSample;

/// How Kurt3D drives.
struct Kurt3dSettings {
    AgentSettings agent = {.geometry = {.trackWidth = 0.27 / 0.75, .maxSpeed = 0.6},  // turns slip by 25 %
                           .motors = {.fullSpeed = 0.64},
                           .modes = {DriveMode::Teleoperation, DriveMode::SafeTeleoperation,
                                     DriveMode::Explore, DriveMode::VictimApproach},
                           .hasRemote = false};
    SelfDrivingSettings driving;
    double lookAside = degrees(70);  ///< while exploring, it looks for heat this far to each side [rad]
    double lookRate = degrees(25);   ///< rate at which it turns the cameras for that [rad/s]
};

/// Drives Kurt3D: by its operator, by its operator within limits of the virtual scan, or by itself with fuzzy
/// control, up to victims (paper, section 2.3). One thread.
class Kurt3dAgent final : public SelfDrivingAgent {
public:
    /// @p fuzzy: rules in resources/control/fuzzy_drive.yaml. Errors are those of FuzzyDrive::create().
    [[nodiscard]] static Result<std::unique_ptr<Kurt3dAgent>> create(RobotHardware& hardware,
                                                                     const RobotDescription& robot,
                                                                     const FuzzySystem& fuzzy,
                                                                     const Kurt3dSettings& settings = {});

private:
    Kurt3dAgent(RobotHardware& hardware, const RobotDescription& robot, const FuzzyDrive& drive,
                const Kurt3dSettings& settings);
    void sense(HardwareSample& sample) override;
    void consider(VirtualScanView& view, const Pose& here, Time now) override;
    DriveVelocity think(const ModeDecision& decision, const Pose& here, Time now) override;
    void thought(const ModeDecision& decision, Time now) override;
    void takeOver(Driver before, Driver now) override;

    void see(const HardwareSample& sample, const PictureSample& picture);
    void lookForHeat(const ModeDecision& decision, Time now);
    DriveVelocity approach(const Pose& here, Time now);
    /// Returns the velocity towards a body that the robot saw while it drove to another body; empty: there is
    /// none.
    [[nodiscard]] std::optional<DriveVelocity> visit(const Pose& here, Time now);
    void leaveVisited();

    Kurt3dSettings m_settings;
    VictimApproach m_approach;
    std::map<std::string, CameraInfoSample> m_cameras;  ///< by sensor
    std::vector<HeatCue> m_cues;                        ///< those of the newest picture that shows a body
    std::optional<HeatCue> m_cue;                       ///< cue that it follows
    /// Heat to which it drives, or in front of which it stands; in odom [m].
    std::optional<Eigen::Vector3d> m_heat;
    PassedHeat m_passed;
    Time m_considered{};                       ///< stamp of the newest picture that was given to m_passed
    std::optional<PassedHeat::One> m_visited;  ///< body from m_passed that it is visiting
    std::optional<Time> m_lookedSince;  ///< when it began to look, at the place from which m_visited was seen
    bool m_looks = false;               ///< whether it has turned the cameras by itself
    std::size_t m_sightings = 0;        ///< number of published sightings
};

}  // namespace leitstand
