#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/robot/control/grant_arbiter.h"
#include "core/robot/control/robot_rules.h"
#include "core/robot/robot_description.h"
#include "robots/control/drive_kinematics.h"
#include "robots/control/modes.h"
#include "robots/control/speed_controller.h"
#include "robots/hardware/robot_hardware.h"

namespace leitstand {

struct GrantSample;
struct JointSample;
struct ModeCommandSample;
struct PoseSample;
struct StreamCommandSample;

/// What the agent of any robot needs to know about its robot.
struct AgentSettings {
    DriveGeometry geometry;
    SpeedControllerSettings motors;
    std::vector<DriveMode> modes = {DriveMode::Teleoperation};  ///< modes that may be requested
    bool hasRemote = false;
    /// Whether it behaves like a stock robot, which obeys anybody; see RobotRuleSettings.
    bool careless = false;
    /// For a careless robot: it stops after this time without commands; 0: never.
    std::chrono::nanoseconds ownWatchdog{};
};

/// What all robots have in common: rules for commands (RobotRules), modes, speed controllers, brake, answers.
/// It has no network, and no clock but that of its hardware. One thread.
class RobotAgent {
public:
    RobotAgent(RobotHardware& hardware, const RobotDescription& robot, const AgentSettings& settings);
    virtual ~RobotAgent() = default;
    RobotAgent(const RobotAgent&) = delete;
    RobotAgent& operator=(const RobotAgent&) = delete;

    void receive(const GrantSample& grant, const Sender& from);
    /// Takes what the process @p from sent on a command stream with @p role.
    void receive(StreamRole role, const Sample& command, const Sender& from);
    /// Runs one cycle of the control loop. Call it every 5 to 10 ms by the robot's clock. Returns all samples
    /// to publish.
    [[nodiscard]] std::vector<HardwareSample> step();

    void press();  ///< presses the robot's own stop button
    [[nodiscard]] DriveMode mode() const { return m_machine.mode(); }

protected:
    /// What the robot's own drivers and sensors report to the modes. Fields are those of ModeInputs.
    struct Report {
        bool cue = false, sent = false, done = false, failed = false;
        std::string text;
    };
    /// Called with each sample of the hardware, before it is published.
    virtual void sense(HardwareSample& sample);
    virtual Report report(Time now);            ///< called once per step, before the modes
    virtual void goTo(const PoseSample& goal);  ///< called with a goal from the holder of the grant
    virtual DriveVelocity steer(const ModeDecision& decision, const DriveVelocity& requested, Time now);

    /// Turns the cameras of the pan-tilt @p unit autonomously [rad]. Within 10 s of a turn by the operator,
    /// who has priority, it does nothing and returns false.
    bool look(const std::string& unit, double pan, double tilt);
    void publish(StreamRole role, Sample sample) { m_published.push_back({role, {}, std::move(sample)}); }
    [[nodiscard]] SampleHeader header() const { return {m_hardware.now(), m_robot.baseFrame}; }
    [[nodiscard]] const RobotDescription& robot() const { return m_robot; }

private:
    [[nodiscard]] SteadyTime steady() const;
    void drive(const DriveVelocity& requested, const Sender& from);
    void driveTracks(const JointSample& tracks, const Sender& from);
    void askForMode(const ModeCommandSample& command);
    /// Takes a mode or a goal. The first request of a new holder may arrive before its grant, which is on
    /// another topic. Such a request is kept for 1 s and obeyed when the grant arrives.
    void receiveRequest(StreamRole role, const Sample& requested, const Sender& from);
    void turnCameras(const PanTiltCommand& command);
    void setStream(const StreamCommandSample& command);
    void move(const DriveVelocity& velocity, bool hold, Time now);
    void publishStopState();

    RobotHardware& m_hardware;
    const RobotDescription m_robot;
    const AgentSettings m_settings;
    RobotRules m_rules;
    GrantArbiter m_cameras;
    ModeMachine m_machine;
    SpeedController m_left, m_right;
    std::optional<Time> m_moved, m_twist, m_camerasTurned;
    struct EarlyRequest {
        StreamRole role;
        Sample requested;
        Sender from;
        Time received;
    };
    std::vector<EarlyRequest> m_early;  ///< oldest first
    std::optional<StopStateSample> m_stopPublished;
    std::map<std::string, std::pair<double, double>> m_panTilt;  ///< pan and tilt of each unit [rad]
    std::vector<HardwareSample> m_published;
};

}  // namespace leitstand
