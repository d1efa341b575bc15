#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/status_samples.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/robot_description.h"
#include "core/robot/robot_format.h"

namespace leitstand {

/// What a robot is doing.
enum class DriveMode : std::uint8_t {
    Stopped,            ///< a stop is in force
    Teleoperation,      ///< the operator drives
    SafeTeleoperation,  ///< the operator drives, the virtual scan limits the speed
    Explore,            ///< drives by itself
    VictimApproach,     ///< drives up to a source of heat by itself
    Remote,             ///< the radio remote drives
};
/// "safe_teleoperation": name in messages and key of RobotDescription::linkLoss.
[[nodiscard]] std::string toString(DriveMode mode);
[[nodiscard]] std::optional<DriveMode> driveModeFrom(std::string_view name);

/// Who moves the robot now.
enum class Driver : std::uint8_t {
    Nobody,           ///< the robot stands, with its brake on
    Operator,         ///< drives with ModeDecision::velocity
    LimitedOperator,  ///< drives with ModeDecision::velocity, limited by SafeTeleoperation
    Explorer,
    Approacher,
    Returner,  ///< drives back to where the link was good
    Remote,    ///< drives with ModeDecision::velocity
};

struct ModeSettings {
    std::chrono::nanoseconds watchdog = DriveWatchdog;             ///< how long commands are valid
    std::chrono::nanoseconds lostAfter = std::chrono::seconds(3);  ///< the link is lost after this silence
    /// Longest time for LinkLossRule::FinishAndWait.
    std::chrono::nanoseconds finishWithin = std::chrono::seconds(60);
    /// Use of the remote ends after this silence.
    std::chrono::nanoseconds remoteIdle = std::chrono::milliseconds(500);
    /// Rules of autonomous modes; a mode that is missing has Stop.
    std::map<std::string, LinkLossRule> linkLoss;
    bool hasRemote = false;
    bool neutralFirst = true;  ///< sticks must be released before they drive; not so on stock robots
    std::vector<DriveMode> modes = {DriveMode::Teleoperation, DriveMode::SafeTeleoperation,
                                    DriveMode::Explore,
                                    DriveMode::VictimApproach};  ///< modes that may be requested
};

/// Inputs of one step of the mode machine.
struct ModeInputs {
    bool stopped = false;                 ///< whether a stop is in force (RobotRules, or the robot's own)
    std::string stopReason;               ///< English text
    std::optional<DriveVelocity> remote;  ///< velocity from the radio remote, while it is in use
    bool cue = false;                     ///< whether the heat detector has found a body to drive to
    bool sent = false;    ///< whether the operator sent the robot somewhere, so that cues must wait
    bool done = false;    ///< whether the last driver has reached its goal, or has finished
    bool failed = false;  ///< ... or has given up
    std::string report;   ///< why it is done or failed, English text
};

/// Result of one step of the mode machine.
struct ModeDecision {
    DriveMode mode = DriveMode::Teleoperation;
    Driver driver = Driver::Nobody;
    DriveVelocity velocity;  ///< for Operator, LimitedOperator, Remote
    std::string reason;      ///< why mode and driver are as they are, English text
    bool changed = false;    ///< whether mode or reason are new and must be published
    bool linkLost = false;
    bool receivedNow = false;      ///< whether the station was heard in the last 0.2 s
    bool waitsForNeutral = false;  ///< whether the sticks must be neutral first
};

/// The modes of a robot and the rules for changing between them. Pure: times are passed in. Motion never
/// begins by itself. The operator's sticks must be neutral first after a stop, a lost link, use of the radio
/// remote, or a change from an autonomous mode. Autonomous modes must be requested again after a stop, a lost
/// link or use of the remote. Exception: with LinkLossRule::FinishAndWait, a mode continues if it still moves
/// when the link returns.
class ModeMachine {
public:
    explicit ModeMachine(const ModeSettings& settings = {});

    /// Requests @p mode for the operator. The error says why it was refused.
    Result<void> request(DriveMode mode, Time now);
    Result<void> request(const std::string& mode, Time now);
    /// Takes the operator's sticks. Call with each command (or each time RobotRules is asked).
    void command(const DriveVelocity& velocity, Time now);
    /// Takes sticks that RobotRules refuses because they were not zero yet.
    void commandBeforeNeutral(const DriveVelocity& velocity, Time now);
    void receivedStation(Time now);  ///< call when anything was received from the station that drives

    ModeDecision step(const ModeInputs& inputs, Time now);

    [[nodiscard]] DriveMode mode() const { return m_mode; }
    [[nodiscard]] bool isAutonomous() const;
    /// Returns the mode as it is published; the caller sets the header.
    [[nodiscard]] ModeSample sample() const;

private:
    enum class Link : std::uint8_t { Good, Standing, Finishing, Returning, Waiting };
    void change(DriveMode mode, const std::string& reason);
    void hold(const std::string& reason);
    void setReason(const std::string& reason);
    void needNeutral();
    void stepStop(const ModeInputs& inputs);
    void stepRemote(const ModeInputs& inputs, Time now);
    void stepLink(const ModeInputs& inputs, Time now);
    void stepDriver(const ModeInputs& inputs);
    void stepSticks(Time now);
    [[nodiscard]] ModeDecision decide(Time now) const;
    [[nodiscard]] LinkLossRule ruleOf(DriveMode mode) const;
    [[nodiscard]] std::string whyNot(DriveMode mode) const;

    ModeSettings m_settings;
    DriveMode m_mode = DriveMode::Teleoperation;
    DriveMode m_manual = DriveMode::Teleoperation;  ///< mode to return to after a stop or the remote
    DriveMode m_before = DriveMode::Teleoperation;  ///< mode before VictimApproach
    std::string m_reason = robot_format::Started;
    std::string m_reasonBefore;  ///< reason at the time when the sticks first had to be neutral
    bool m_changed = true;
    bool m_held = false;     ///< whether an autonomous mode is suspended until it is requested again
    bool m_neutral = false;  ///< whether the sticks were neutral since that was last required, or need not be
    bool m_cue = false;
    Link m_link = Link::Good;
    Time m_lostAt{}, m_backAt{};  ///< when the link was lost, and when it returned
    /// Reason of the mode before the link was lost; reported again some time after it returned.
    std::string m_reasonBeforeLoss;
    std::optional<Time> m_received, m_commandAt, m_remoteAt;
    DriveVelocity m_command, m_remote;
};

}  // namespace leitstand
