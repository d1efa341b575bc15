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
    Stopped,            ///< the stop stands
    Teleoperation,      ///< the operator drives
    SafeTeleoperation,  ///< the operator drives, the virtual scan limits the speed
    Explore,            ///< drives by itself
    VictimApproach,     ///< drives up to a source of heat by itself
    Remote,             ///< the radio remote drives
};
/// "safe_teleoperation": name on the wire and key of RobotDescription::linkLoss.
[[nodiscard]] std::string toString(DriveMode mode);
[[nodiscard]] std::optional<DriveMode> driveModeFrom(std::string_view name);

/// Who moves the robot now.
enum class Driver : std::uint8_t {
    Nobody,           ///< the robot stands, with its brake on
    Operator,         ///< ModeDecision::velocity
    LimitedOperator,  ///< ModeDecision::velocity, after SafeTeleoperation
    Explorer,
    Approacher,
    Returner,  ///< drives back to where the link was good
    Remote,    ///< ModeDecision::velocity
};

struct ModeSettings {
    std::chrono::nanoseconds watchdog = DriveWatchdog;                     ///< how long commands are valid
    std::chrono::nanoseconds lostAfter = std::chrono::seconds(3);          ///< silence until the link is lost
    std::chrono::nanoseconds finishWithin = std::chrono::seconds(60);      ///< longest FinishAndWait
    std::chrono::nanoseconds remoteIdle = std::chrono::milliseconds(500);  ///< silence that ends remote use
    std::map<std::string, LinkLossRule> linkLoss;  ///< of autonomous modes; none: Stop
    bool hasRemote = false;
    bool neutralFirst =
        true;  ///< sticks must be released before they drive; stock robots do not ask for that
    std::vector<DriveMode> modes = {DriveMode::Teleoperation, DriveMode::SafeTeleoperation,
                                    DriveMode::Explore,
                                    DriveMode::VictimApproach};  ///< that may be requested
};

/// Inputs of one step of the machine.
struct ModeInputs {
    bool stopped = false;                 ///< the stop stands (RobotRules, or the robot's own)
    std::string stopReason;               ///< in words
    std::optional<DriveVelocity> remote;  ///< of the radio remote, while it is in use
    bool cue = false;                     ///< the heat detector has a body to go to
    bool sent = false;                    ///< the operator sent the robot somewhere; cues must wait
    bool done = false;                    ///< the last driver has reached its aim, or is at the end
    bool failed = false;                  ///< ... or has given up
    std::string report;                   ///< of done or failed, in words
};

/// Result of one step of the machine.
struct ModeDecision {
    DriveMode mode = DriveMode::Teleoperation;
    Driver driver = Driver::Nobody;
    DriveVelocity velocity;  ///< of Operator, LimitedOperator, Remote
    std::string reason;      ///< why mode and driver are as they are, in words
    bool changed = false;    ///< mode or reason are new: to be published
    bool linkLost = false;
    bool receivedNow = false;      ///< the station was heard in the last 0.2 s
    bool waitsForNeutral = false;  ///< the sticks must be neutral first
};

/// The modes of a robot and the rules between them. Pure: times are passed in. Motion never begins by itself.
/// The operator's sticks must be neutral first after a stop, a lost link, use of the radio remote, or a
/// change from an autonomous mode. Autonomous modes must be requested again after a stop, a lost link or use
/// of the remote. Exception: with LinkLossRule::FinishAndWait, a mode goes on if it still moves when the link
/// is back.
class ModeMachine {
public:
    explicit ModeMachine(const ModeSettings& settings = {});

    /// Requests @p mode for the operator. The error is the reason of a refusal.
    Result<void> request(DriveMode mode, Time now);
    Result<void> request(const std::string& mode, Time now);
    /// Takes the operator's sticks, each time a command comes (or each time RobotRules is asked).
    void command(const DriveVelocity& velocity, Time now);
    /// Takes sticks that RobotRules refuses until they were zero.
    void commandBeforeNeutral(const DriveVelocity& velocity, Time now);
    void receivedStation(Time now);  ///< anything came from the station that drives

    ModeDecision step(const ModeInputs& inputs, Time now);

    [[nodiscard]] DriveMode mode() const { return m_mode; }
    [[nodiscard]] bool isAutonomous() const;
    /// Returns the mode as it is published; the header is left to the caller.
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
    DriveMode m_manual = DriveMode::Teleoperation;  ///< to come back to after stop and remote
    DriveMode m_before = DriveMode::Teleoperation;  ///< mode before VictimApproach
    std::string m_reason = robot_format::Started;
    std::string m_reasonBefore;  ///< reason before the sticks had to be neutral
    bool m_changed = true;
    bool m_held = false;     ///< an autonomous mode that stands until it is asked for again
    bool m_neutral = false;  ///< the sticks were neutral since that was last required, or need not be
    bool m_cue = false;
    Link m_link = Link::Good;
    Time m_lostAt{}, m_backAt{};     ///< of the link
    std::string m_reasonBeforeLoss;  ///< reason of the mode, reported again some time after the link is back
    std::optional<Time> m_received, m_commandAt, m_remoteAt;
    DriveVelocity m_command, m_remote;
};

}  // namespace leitstand
