#include "app/services/station/cameras/camera_turning.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds LeftAlone(10);  ///< time without use, before another station gets the cameras

GrantId cameraGrant(const std::string& robot) {
    return {GrantSample::Kind::Camera, robot};
}

SteadyTime now() {
    return std::chrono::steady_clock::now();
}

}  // namespace

CameraTurning::CameraTurning(const std::vector<RobotDescription>& robots, Wire wire)
    : m_wire(std::move(wire)) {
    for (const RobotDescription& robot : robots) {
        if (robot.stream(StreamRole::PanTiltCommand) == nullptr) continue;
        for (const auto& [sensor, description] : robot.sensors) {
            if (!description.panTilt) continue;
            const PanTiltMount& mount = *description.panTilt;
            m_units.try_emplace({robot.name, mount.unit}, mount);
            m_unitOf[{robot.name, sensor}] = mount.unit;
        }
    }
}

void CameraTurning::onEvent(const Event& event) {
    const auto* joints = event.sample.as<JointSample>();
    if (joints == nullptr || event.role != StreamRole::Joints) return;
    const auto angleOf = [joints](const std::string& joint) -> std::optional<double> {
        const auto found = std::find(joints->names.begin(), joints->names.end(), joint);
        const auto at = static_cast<std::size_t>(found - joints->names.begin());
        if (at >= joints->positions.size()) return std::nullopt;
        return joints->positions[at];
    };
    const std::scoped_lock lock(m_mutex);
    for (auto& [unit, control] : m_units) {
        if (unit.first != event.robot) continue;
        const auto pan = angleOf(unit.second + "_pan"), tilt = angleOf(unit.second + "_tilt");
        if (!pan && !tilt) continue;
        const PanTiltAngles before = control.now().value_or(PanTiltAngles{});
        control.reported({pan.value_or(before.pan), tilt.value_or(before.tilt)});
    }
}

std::optional<CameraTurn> CameraTurning::view(const std::string& robot, const std::string& sensor) const {
    const GrantView grant = m_wire.grant(cameraGrant(robot));
    const bool may = maySend(robot);
    const std::scoped_lock lock(m_mutex);
    const auto unit = m_unitOf.find({robot, sensor});
    if (unit == m_unitOf.end()) return std::nullopt;
    const PanTiltControl& control = m_units.at({robot, unit->second});
    CameraTurn turn{control.mount(), control.now(), control.requested(), false, {}};
    turn.waiting = control.requested().has_value() && !may;
    if (!grant.mine && !grant.holder.empty())
        turn.heldBy = grant.holderTitle.empty() ? grant.holder : grant.holderTitle;
    return turn;
}

PanTiltControl* CameraTurning::find(const std::string& robot, const std::string& sensor) {
    const auto unit = m_unitOf.find({robot, sensor});
    return unit == m_unitOf.end() ? nullptr : &m_units.at({robot, unit->second});
}

void CameraTurning::want(const std::string& robot) {
    m_uses[robot] = {now(), false};
    if (!m_wire.grant(cameraGrant(robot)).mine) m_wire.ask(cameraGrant(robot));
}

void CameraTurning::turnTo(const std::string& robot, const std::string& sensor, const PanTiltAngles& angles) {
    const std::scoped_lock lock(m_mutex);
    PanTiltControl* const control = find(robot, sensor);
    if (control == nullptr) return;
    control->turnTo(angles, now());
    want(robot);
}

void CameraTurning::turnBy(const std::string& robot, const std::string& sensor, const PanTiltAngles& step) {
    const std::scoped_lock lock(m_mutex);
    PanTiltControl* const control = find(robot, sensor);
    if (control == nullptr) return;
    control->turnBy(step, now());
    want(robot);
}

void CameraTurning::setRate(const std::string& robot, const std::string& sensor,
                            const PanTiltAngles& perSecond) {
    const std::scoped_lock lock(m_mutex);
    PanTiltControl* const control = find(robot, sensor);
    if (control == nullptr) return;
    control->setRate(perSecond, now());
    if (perSecond != PanTiltAngles{}) want(robot);
}

void CameraTurning::recentre(const std::string& robot) {
    const std::scoped_lock lock(m_mutex);
    bool any = false;
    for (auto& [unit, control] : m_units) {
        if (unit.first != robot) continue;
        control.turnTo({}, now());
        any = true;
    }
    if (any) want(robot);
}

bool CameraTurning::maySend(const std::string& robot) const {
    if (m_wire.mayAct(cameraGrant(robot))) return true;
    return m_wire.grant(cameraGrant(robot)).holder.empty() && m_wire.mayAct(driveGrant(robot));
}

void CameraTurning::answer() {
    for (const auto& [robot, use] : m_uses) {
        const GrantView grant = m_wire.grant(cameraGrant(robot));
        if (grant.mine && !grant.requestedBy.empty() && now() - use.last > LeftAlone)
            m_wire.answer(cameraGrant(robot), true);
    }
}

Result<void> CameraTurning::pulse() {
    Result<void> outcome;
    const std::scoped_lock lock(m_mutex);
    answer();
    std::map<std::string, PanTiltCommand> commands;
    for (auto& [unit, control] : m_units) {
        const auto angles = control.due(now());
        if (!angles) continue;
        if (control.turning()) m_uses[unit.first].last = now();
        PanTiltCommand& command = commands[unit.first];
        command.names.insert(command.names.end(), {unit.second + "_pan", unit.second + "_tilt"});
        command.positions.insert(command.positions.end(), {angles->pan, angles->tilt});
    }
    for (const auto& [robot, command] : commands) {
        if (!maySend(robot)) continue;  // due again until the grant is held, or the wish is dropped
        auto sent = m_wire.send(robot, command);
        if (!sent && !std::exchange(m_uses[robot].failed, true)) outcome = sent.error();
    }
    return outcome;
}

}  // namespace leitstand
