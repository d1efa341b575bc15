#include "robots/agent/robot_agent.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/base/time.h"
#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

constexpr auto OperatorLooks = std::chrono::seconds(10);
const auto EarlyFor = RobotRuleSettings().early;  ///< how long a wish waits for its sender's grant
constexpr std::size_t MostEarly = 8;
constexpr auto ForEver = std::chrono::hours(24 * 365);
constexpr double AtRest = 0.03;  ///< slower sides are held by the brake [m/s]

RobotRuleSettings rulesOf(const RobotDescription& robot, const AgentSettings& settings, Time now) {
    return {.limits = limitsOf(robot),
            .firstStop = static_cast<std::uint64_t>(now.time_since_epoch().count()),
            .careless = settings.careless};
}

ModeSettings modesOf(const RobotDescription& robot, const AgentSettings& settings) {
    ModeSettings modes;
    modes.linkLoss = robot.linkLoss;
    modes.hasRemote = settings.hasRemote;
    modes.modes = settings.modes;
    if (settings.careless) {
        const bool none = settings.ownWatchdog == std::chrono::nanoseconds(0);
        modes.lostAfter = ForEver;
        modes.neutralFirst = false;
        modes.watchdog = none ? std::chrono::nanoseconds(ForEver) : settings.ownWatchdog;
    }
    return modes;
}

DriveVelocity velocityOf(const TwistSample& twist) {
    return {twist.linear.x(), twist.linear.y(), twist.angular.z()};
}

bool sameState(const StopStateSample& a, const StopStateSample& b) {
    const auto reported = [](const StopStateSample& state) {
        return std::tie(state.number, state.station, state.stopped, state.standing, state.refused,
                        state.stops);
    };
    return reported(a) == reported(b);
}

}  // namespace

RobotAgent::RobotAgent(RobotHardware& hardware, const RobotDescription& robot, const AgentSettings& settings)
    : m_hardware(hardware),
      m_robot(robot),
      m_settings(settings),
      m_rules(robot.name, rulesOf(robot, settings, hardware.now())),
      m_cameras({GrantSample::Kind::Camera, robot.name}),
      m_machine(modesOf(robot, settings)),
      m_left(settings.motors),
      m_right(settings.motors) {
    m_hardware.setMotors(0.0, 0.0);
    m_hardware.setBrake(true);
}

void RobotAgent::sense(HardwareSample& sample) {
    static_cast<void>(sample);
}

RobotAgent::Report RobotAgent::report(Time now) {
    static_cast<void>(now);
    return {};
}

void RobotAgent::goTo(const PoseSample& goal) {
    static_cast<void>(goal);
}

DriveVelocity RobotAgent::steer(const ModeDecision& decision, const DriveVelocity& requested, Time now) {
    static_cast<void>(now);
    return decision.driver == Driver::Nobody ? DriveVelocity{} : requested;
}

SteadyTime RobotAgent::steady() const {
    return SteadyTime(std::chrono::duration_cast<SteadyTime::duration>(m_hardware.now().time_since_epoch()));
}

void RobotAgent::receive(const GrantSample& grant, const Sender& from) {
    m_rules.receive(grant, from, steady());
    m_cameras.receive(grant, from, steady());
    if (!m_rules.grant().obeys(from, steady())) return;
    m_machine.receivedStation(m_hardware.now());
    for (const EarlyRequest& early : std::exchange(m_early, {})) {
        if (early.from == from && m_hardware.now() - early.received < EarlyFor)
            receiveRequest(early.role, early.requested, from);
    }
}

void RobotAgent::receiveRequest(StreamRole role, const Sample& requested, const Sender& from) {
    if (!m_rules.grant().obeys(from, steady())) {
        if (m_early.size() >= MostEarly) m_early.erase(m_early.begin());
        m_early.push_back({role, requested, from, m_hardware.now()});
        return;
    }
    if (const auto* mode = requested.as<ModeCommandSample>()) askForMode(*mode);
    if (const auto* goal = requested.as<PoseSample>()) goTo(*goal);
}

void RobotAgent::receive(StreamRole role, const Sample& command, const Sender& from) {
    const bool holder = m_rules.grant().obeys(from, steady());
    if (holder) m_machine.receivedStation(m_hardware.now());
    if (const auto* twist = command.as<TwistSample>()) {
        m_twist = m_hardware.now();
        drive(velocityOf(*twist), from);
    } else if (const auto* stop = command.as<StopCommandSample>()) {
        static_cast<void>(m_rules.receive(*stop, from, steady()));
        m_stopPublished.reset();  // every command is answered
        publishStopState();
    } else if (command.is<ModeCommandSample>() || command.is<PoseSample>()) {
        receiveRequest(role, command, from);
    } else if (const auto* joints = command.as<JointSample>()) {
        const bool mayLook = m_cameras.holder(steady()).empty() ? holder : m_cameras.obeys(from, steady());
        if (role == StreamRole::TrackCommand) driveTracks(*joints, from);
        if (role == StreamRole::PanTiltCommand && mayLook) turnCameras(*joints);
    } else if (const auto* stream = command.as<StreamCommandSample>()) {
        if (holder || m_rules.grant().holder(steady()).empty()) setStream(*stream);
    } else if (const auto* ping = command.as<PingSample>()) {
        const Time now = m_hardware.now();
        publish(StreamRole::Pong, PongSample{ping->number, ping->station, ping->sent, now, now});
    }
}

void RobotAgent::drive(const DriveVelocity& requested, const Sender& from) {
    const DriveVerdict verdict = m_rules.drive(requested, from, steady());
    if (verdict == DriveVerdict::Taken) m_machine.command(m_rules.commanded(steady()), m_hardware.now());
    if (verdict == DriveVerdict::NotNeutral) m_machine.commandBeforeNeutral(requested, m_hardware.now());
    if (verdict == DriveVerdict::NoNumber) m_machine.command({}, m_hardware.now());
}

void RobotAgent::driveTracks(const JointSample& tracks, const Sender& from) {
    // Twists take precedence: commands of two stations, or of two widgets of one, do not alternate.
    if (m_twist && m_hardware.now() - *m_twist < std::chrono::milliseconds(300)) return;
    SideSpeeds sides{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    for (std::size_t i = 0; i < std::min(tracks.names.size(), tracks.velocities.size()); ++i) {
        if (tracks.names[i] == "left_track") sides.left = tracks.velocities[i];
        if (tracks.names[i] == "right_track") sides.right = tracks.velocities[i];
    }
    drive(leitstand::velocityOf(sides, m_settings.geometry), from);
}

void RobotAgent::askForMode(const ModeCommandSample& command) {
    const auto asked = m_machine.request(command.mode, m_hardware.now());
    if (asked) return;
    ModeSample mode = m_machine.sample();
    mode.header = header();
    mode.reason = asked.error().text;
    publish(StreamRole::Mode, mode);
}

void RobotAgent::turnCameras(const PanTiltCommand& command) {
    for (std::size_t i = 0; i < std::min(command.names.size(), command.positions.size()); ++i) {
        const std::string& joint = command.names[i];
        const auto cut = joint.rfind('_');
        if (cut == std::string::npos || !std::isfinite(command.positions[i])) continue;
        auto& [pan, tilt] = m_panTilt[joint.substr(0, cut)];
        if (joint.substr(cut) == "_pan") pan = command.positions[i];
        if (joint.substr(cut) == "_tilt") tilt = command.positions[i];
    }
    for (const auto& [unit, angles] : m_panTilt) m_hardware.setPanTilt(unit, angles.first, angles.second);
    m_camerasTurned = m_hardware.now();
}

bool RobotAgent::look(const std::string& unit, double pan, double tilt) {
    if (m_camerasTurned && m_hardware.now() - *m_camerasTurned < OperatorLooks) return false;
    m_panTilt[unit] = {pan, tilt};
    m_hardware.setPanTilt(unit, pan, tilt);
    return true;
}

void RobotAgent::setStream(const StreamCommandSample& command) {
    for (const StreamDescription& stream : m_robot.streams) {
        if (stream.topic != command.topic || isCommand(stream.role)) continue;
        m_hardware.setStream(stream.role, stream.sensor,
                             {command.enabled, command.rate, command.quality, command.maxWidth});
    }
}

void RobotAgent::press() {
    m_rules.press();
    m_stopPublished.reset();
}

void RobotAgent::publishStopState() {
    StopStateSample state = m_rules.stopState(steady());
    if (m_stopPublished && sameState(*m_stopPublished, state)) return;
    state.header = header();
    m_stopPublished = state;
    publish(StreamRole::StopState, state);
}

void RobotAgent::move(const DriveVelocity& velocity, bool hold, Time now) {
    const double seconds = m_moved ? toSeconds(now - *m_moved) : 0.005;
    m_moved = now;
    const TrackState tracks = m_hardware.tracks();
    const bool atRest = std::abs(tracks.left) < AtRest && std::abs(tracks.right) < AtRest;
    if (hold || (isZero(velocity) && atRest)) {
        m_left.reset();
        m_right.reset();
        m_hardware.setMotors(0.0, 0.0);
        m_hardware.setBrake(true);
        return;
    }
    const SideSpeeds sides = sidesFor(velocity, m_settings.geometry);
    m_hardware.setBrake(false);
    m_hardware.setMotors(m_left.step(sides.left, tracks.left, seconds),
                         m_right.step(sides.right, tracks.right, seconds));
}

std::vector<HardwareSample> RobotAgent::step() {
    const Time now = m_hardware.now();
    std::vector<HardwareSample> sensed = m_hardware.take();
    for (HardwareSample& sample : sensed) {
        if (sample.reach == Reach::Sent) continue;
        if (const auto* odometry = sample.sample.as<OdometrySample>())
            m_rules.moved(odometry->linear.head<2>().norm(), odometry->angular.z(), steady());
        sense(sample);
    }
    std::erase_if(sensed, [](const HardwareSample& sample) { return sample.reach == Reach::OnBoard; });
    Report report = this->report(now);
    ModeInputs inputs;
    inputs.stopped = m_rules.isStopped();
    if (inputs.stopped) {
        const std::string by = m_rules.stopState(steady()).station;
        inputs.stopReason =
            by.empty() ? robot_format::StoppedByButton : fmt::format(robot_format::StoppedBy, by);
    }
    if (const auto remote = m_hardware.remote()) inputs.remote = velocityOf(*remote);
    inputs.cue = report.cue;
    inputs.sent = report.sent;
    inputs.done = report.done;
    inputs.failed = report.failed;
    inputs.report = std::move(report.text);
    const ModeDecision decision = m_machine.step(inputs, now);
    if (decision.changed) {
        ModeSample mode = m_machine.sample();
        mode.header = header();
        publish(StreamRole::Mode, mode);
    }
    DriveVelocity requested = decision.velocity;
    const bool operated = decision.driver == Driver::Operator || decision.driver == Driver::LimitedOperator;
    if (operated && isZero(m_rules.commanded(steady()))) requested = {};
    const DriveVelocity velocity = limited(steer(decision, requested, now), limitsOf(m_robot));
    move(velocity, inputs.stopped || decision.driver == Driver::Nobody, now);
    publishStopState();
    sensed.insert(sensed.end(), std::make_move_iterator(m_published.begin()),
                  std::make_move_iterator(m_published.end()));
    m_published.clear();
    return sensed;
}

}  // namespace leitstand
