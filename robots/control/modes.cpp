#include "robots/control/modes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/event/scan_links.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds NewsFor(5);  ///< how long "the link is back" is reported
constexpr std::array<std::pair<DriveMode, std::string_view>, 6> Names = {
    {{DriveMode::Stopped, "stopped"},
     {DriveMode::Teleoperation, "teleoperation"},
     {DriveMode::SafeTeleoperation, "safe_teleoperation"},
     {DriveMode::Explore, "explore"},
     {DriveMode::VictimApproach, "victim_approach"},
     {DriveMode::Remote, "remote"}}};

bool isManual(DriveMode mode) {
    return mode == DriveMode::Teleoperation || mode == DriveMode::SafeTeleoperation;
}

bool isFinite(const DriveVelocity& velocity) {
    return std::isfinite(velocity.forward) && std::isfinite(velocity.left) && std::isfinite(velocity.turn);
}

}  // namespace

std::string toString(DriveMode mode) {
    for (const auto& [one, name] : Names) {
        if (one == mode) return std::string(name);
    }
    return "stopped";
}

std::optional<DriveMode> driveModeFrom(std::string_view name) {
    for (const auto& [mode, one] : Names) {
        if (one == name) return mode;
    }
    return std::nullopt;
}

ModeMachine::ModeMachine(const ModeSettings& settings) : m_settings(settings) {}

bool ModeMachine::isAutonomous() const {
    return m_mode == DriveMode::Explore || m_mode == DriveMode::VictimApproach;
}

std::string ModeMachine::whyNot(DriveMode mode) const {
    const bool offered =
        std::find(m_settings.modes.begin(), m_settings.modes.end(), mode) != m_settings.modes.end();
    if (mode == DriveMode::Stopped || mode == DriveMode::Remote || !offered)
        return fmt::format(robot_format::CannotBeAskedFor, toString(mode));
    if (m_mode == DriveMode::Stopped) return robot_format::StopStands;
    if (m_mode == DriveMode::Remote) return robot_format::RemoteInUse;
    if (mode == DriveMode::VictimApproach && !m_cue) return robot_format::NoHeatInSight;
    return {};
}

Result<void> ModeMachine::request(const std::string& mode, Time now) {
    const auto wanted = driveModeFrom(mode);
    if (!wanted) return Error{fmt::format(robot_format::NoMode, mode)};
    return request(*wanted, now);
}

Result<void> ModeMachine::request(DriveMode mode, Time now) {
    if (const std::string reason = whyNot(mode); !reason.empty()) return Error{reason};
    receivedStation(now);
    const bool sameSticks = isManual(m_mode) && isManual(mode);
    if (mode == DriveMode::VictimApproach && m_mode != mode)
        m_before = m_mode == DriveMode::Explore ? DriveMode::Explore : m_manual;
    if (isManual(mode)) m_manual = mode;
    m_held = false;
    m_link = Link::Good;
    if (!sameSticks) needNeutral();
    change(mode, robot_format::AskedFor);
    return {};
}

void ModeMachine::command(const DriveVelocity& velocity, Time now) {
    receivedStation(now);
    m_command = isFinite(velocity) ? velocity : DriveVelocity{};
    m_commandAt = now;
    if ((isZero(m_command) || !m_settings.neutralFirst) && isManual(m_mode)) m_neutral = true;
}

void ModeMachine::commandBeforeNeutral(const DriveVelocity& velocity, Time now) {
    command(velocity, now);
    m_neutral = false;
}

void ModeMachine::receivedStation(Time now) {
    m_received = m_received ? std::max(*m_received, now) : now;
}

void ModeMachine::change(DriveMode mode, const std::string& reason) {
    if (mode != m_mode) m_changed = true;
    m_mode = mode;
    setReason(reason);
}

void ModeMachine::setReason(const std::string& reason) {
    if (reason == m_reason) return;
    m_reason = reason;
    m_changed = true;
}

void ModeMachine::hold(const std::string& reason) {
    m_held = true;
    setReason(reason);
}

void ModeMachine::needNeutral() {
    m_neutral = !m_settings.neutralFirst;
    m_command = {};
}

void ModeMachine::stepStop(const ModeInputs& inputs) {
    if (inputs.stopped) {
        needNeutral();
        m_held = false;
        m_link = Link::Good;
        change(DriveMode::Stopped, inputs.stopReason.empty() ? robot_format::Stop : inputs.stopReason);
    } else if (m_mode == DriveMode::Stopped) {
        needNeutral();
        change(m_manual, robot_format::Released);
    }
}

void ModeMachine::stepRemote(const ModeInputs& inputs, Time now) {
    if (!m_settings.hasRemote) return;
    if (inputs.remote) {
        m_remoteAt = now;
        m_remote = isFinite(*inputs.remote) ? *inputs.remote : DriveVelocity{};
    } else {
        m_remote = {};
    }
    const bool inUse = m_remoteAt && now - *m_remoteAt < m_settings.remoteIdle;
    if (m_mode == DriveMode::Stopped) return;  // the stop overrides the remote
    if (inUse && m_mode != DriveMode::Remote) {
        needNeutral();
        m_held = false;
        m_link = Link::Good;
        change(DriveMode::Remote, robot_format::RemoteInUse);
    } else if (!inUse && m_mode == DriveMode::Remote) {
        needNeutral();
        change(m_manual, robot_format::RemoteLetGo);
    }
}

LinkLossRule ModeMachine::ruleOf(DriveMode mode) const {
    const auto rule = m_settings.linkLoss.find(toString(mode));
    if (rule == m_settings.linkLoss.end() || isManual(mode)) return LinkLossRule::Stop;
    return rule->second;
}

void ModeMachine::stepLink(const ModeInputs& inputs, Time now) {
    if (m_mode == DriveMode::Stopped || m_mode == DriveMode::Remote) return;
    const bool lost = !m_received || now - *m_received > m_settings.lostAfter;
    if (!lost) {
        if (m_link == Link::Good) {
            const bool reported =
                m_reason == robot_format::LinkBack || m_reason == robot_format::LinkBackGoesOn;
            if (reported && now - m_backAt > NewsFor) setReason(m_reasonBeforeLoss);
            return;
        }
        m_backAt = now;
        // A mode that kept moving goes on; one that stands waits.
        if (m_link == Link::Finishing) {
            setReason(robot_format::LinkBackGoesOn);
        } else if (isAutonomous()) {
            hold(robot_format::LinkBackWaits);
        } else {
            setReason(robot_format::LinkBack);
        }
        m_link = Link::Good;
        return;
    }
    if (m_link == Link::Good) {
        m_lostAt = now;
        const bool reported = m_reason == robot_format::LinkBack ||
                              m_reason == robot_format::LinkBackGoesOn ||
                              m_reason == robot_format::NeutralFirst;
        if (!reported) m_reasonBeforeLoss = m_reason;
        needNeutral();
        if (!m_received) {
            m_link = Link::Standing;
            return;
        }
        switch (m_held ? LinkLossRule::Stop : ruleOf(m_mode)) {
            case LinkLossRule::Stop:
                m_link = Link::Standing;
                setReason(robot_format::LinkLostStands);
                break;
            case LinkLossRule::FinishAndWait:
                m_link = Link::Finishing;
                setReason(robot_format::LinkLostFinishes);
                break;
            case LinkLossRule::ReturnToLink:
                m_link = Link::Returning;
                setReason(robot_format::LinkLostReturns);
                break;
        }
        return;
    }
    const bool over = inputs.done || inputs.failed;
    if (m_link == Link::Finishing && (over || now - m_lostAt > m_settings.finishWithin)) {
        m_link = Link::Waiting;
        hold(inputs.done ? robot_format::LinkLostFinished : robot_format::LinkLostWaits);
    } else if (m_link == Link::Returning && over) {
        m_link = Link::Waiting;
        hold(inputs.done ? robot_format::LinkLostIsBack : robot_format::LinkLostNoWay);
    }
}

void ModeMachine::stepDriver(const ModeInputs& inputs) {
    m_cue = inputs.cue;
    if (!isAutonomous() || m_held || m_link == Link::Standing || m_link == Link::Returning) return;
    const std::string& report = inputs.report;
    if (m_mode == DriveMode::Explore) {
        if (inputs.cue && !inputs.sent && whyNot(DriveMode::VictimApproach).empty()) {
            m_before = DriveMode::Explore;
            change(DriveMode::VictimApproach, robot_format::HeatInSight);
        } else if (inputs.done || inputs.failed) {
            hold(report.empty() ? robot_format::NothingLeft : report);
        }
        return;
    }
    if (inputs.done) {
        hold(report.empty() ? robot_format::AtAVictim : report);
    } else if (inputs.failed) {
        const std::string why = report.empty() ? robot_format::GaveUp : report;
        if (m_before != DriveMode::Explore) needNeutral();
        change(m_before, why);
    }
}

/// Reports sticks that are held and do nothing: otherwise the operator would not know why.
void ModeMachine::stepSticks(Time now) {
    const bool held = m_commandAt && now - *m_commandAt < m_settings.watchdog && !isZero(m_command);
    const bool waits = held && isManual(m_mode) && !m_neutral && m_link == Link::Good;
    const bool reported = m_reason == robot_format::NeutralFirst;
    if (waits && !reported) {
        m_reasonBefore = m_reason;
        setReason(robot_format::NeutralFirst);
    } else if (!waits && reported) {
        setReason(m_reasonBefore);
    }
}

ModeDecision ModeMachine::decide(Time now) const {
    ModeDecision decision;
    decision.mode = m_mode;
    decision.reason = m_reason;
    decision.linkLost = m_link != Link::Good;
    decision.receivedNow = m_received && now - *m_received < std::chrono::milliseconds(200);
    decision.waitsForNeutral = isManual(m_mode) && !m_neutral;
    switch (m_mode) {
        case DriveMode::Stopped:
            break;
        case DriveMode::Remote:
            decision.driver = Driver::Remote;
            decision.velocity = m_remote;
            break;
        case DriveMode::Teleoperation:
        case DriveMode::SafeTeleoperation: {
            const bool fresh = m_commandAt && now - *m_commandAt < m_settings.watchdog;
            if (!fresh || !m_neutral || m_link != Link::Good) break;
            decision.driver = m_mode == DriveMode::Teleoperation ? Driver::Operator : Driver::LimitedOperator;
            decision.velocity = m_command;
            break;
        }
        case DriveMode::Explore:
        case DriveMode::VictimApproach:
            if (m_held || m_link == Link::Standing || m_link == Link::Waiting) break;
            if (m_link == Link::Returning) {
                decision.driver = Driver::Returner;
            } else {
                decision.driver = m_mode == DriveMode::Explore ? Driver::Explorer : Driver::Approacher;
            }
            break;
    }
    return decision;
}

ModeDecision ModeMachine::step(const ModeInputs& inputs, Time now) {
    stepStop(inputs);
    stepRemote(inputs, now);
    stepLink(inputs, now);
    stepDriver(inputs);
    stepSticks(now);
    ModeDecision decision = decide(now);
    decision.changed = std::exchange(m_changed, false);
    return decision;
}

ModeSample ModeMachine::sample() const {
    ModeSample sample;
    sample.mode = toString(m_mode);
    sample.autonomous = isAutonomous();
    sample.reason = m_reason;
    for (const DriveMode mode : m_settings.modes) {
        if (whyNot(mode).empty()) sample.available.push_back(toString(mode));
    }
    return sample;
}

}  // namespace leitstand
