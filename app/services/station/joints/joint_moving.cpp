#include "app/services/station/joints/joint_moving.h"

#include <algorithm>
#include <chrono>

#include "core/base/time.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Period(50);

}  // namespace

JointMoving::JointMoving(const std::vector<RobotDescription>& robots, Wire wire) : m_wire(std::move(wire)) {
    for (const RobotDescription& robot : robots) {
        for (const JointGroup& group : robot.jointGroups)
            m_parts.try_emplace({robot.name, group.name}, Part{JointControl(group)});
    }
    if (!m_parts.empty()) m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

JointMoving::~JointMoving() {
    end();
}

void JointMoving::end() {
    if (!m_thread.joinable()) return;
    m_thread.request_stop();
    m_thread.join();
    for (auto& [key, part] : m_parts) {
        const std::scoped_lock lock(m_mutex);
        const bool moved = part.control.isMoving();
        part.control.halt();
        const auto last = part.control.due({}, steadyNow());
        if (moved && last) (void)m_wire.send(key.first, part.control.group(), *last);
    }
}

bool JointMoving::isMoving(const std::string& robot) const {
    const std::scoped_lock lock(m_mutex);
    return std::any_of(m_parts.begin(), m_parts.end(), [&](const auto& one) {
        return one.first.first == robot && one.second.control.isMoving();
    });
}

void JointMoving::onEvent(const Event& event) {
    const auto* joints = event.sample.as<JointSample>();
    if (joints == nullptr || event.role != StreamRole::Joints) return;
    const SteadyTime now = steadyNow();
    const std::scoped_lock lock(m_mutex);
    for (auto& [key, part] : m_parts) {
        if (key.first == event.robot) part.control.reported(*joints, now);
    }
}

std::optional<JointGroupView> JointMoving::view(const std::string& robot, const std::string& group) const {
    const auto found = m_parts.find({robot, group});  // the map itself never changes
    if (found == m_parts.end()) return std::nullopt;
    const bool mayMove = m_wire.conditions(robot).mayMove;
    const SteadyTime now = steadyNow();
    const std::scoped_lock lock(m_mutex);
    const JointControl& control = found->second.control;
    JointGroupView view{{}, control.motion(), control.preset(), mayMove};
    for (std::size_t i = 0; i < control.group().joints.size(); ++i)
        view.positions.push_back(control.position(i, now));
    return view;
}

void JointMoving::move(const std::string& robot, const std::string& group, std::size_t axis, double share) {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_parts.find({robot, group});
    if (found != m_parts.end()) found->second.control.move(axis, share, steadyNow());
}

void JointMoving::goTo(const std::string& robot, const std::string& group, std::size_t preset) {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_parts.find({robot, group});
    if (found != m_parts.end()) found->second.control.goTo(preset, steadyNow());
}

void JointMoving::halt(const std::string& robot) {
    const std::scoped_lock lock(m_mutex);
    for (auto& [key, part] : m_parts) {
        if (key.first == robot) part.control.halt();
    }
}

void JointMoving::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        pulse();
        std::unique_lock lock(m_waiting);
        m_wake.wait_for(lock, stop, Period, [] { return false; });
    }
}

void JointMoving::pulse() {
    for (auto& [key, part] : m_parts) {  // the map itself never changes
        const JointConditions conditions = m_wire.conditions(key.first);
        std::optional<JointSetpoints> setpoints;
        {
            const std::scoped_lock lock(m_mutex);
            setpoints = part.control.due(conditions, steadyNow());
        }
        if (setpoints) report(key, m_wire.send(key.first, part.control.group(), *setpoints));
    }
}

void JointMoving::report(const Key& key, const Result<void>& sent) {
    {
        const std::scoped_lock lock(m_mutex);
        if (std::exchange(m_parts.at(key).failed, !sent) || sent) return;
    }
    m_wire.notify(sent.error().text);
}

}  // namespace leitstand
