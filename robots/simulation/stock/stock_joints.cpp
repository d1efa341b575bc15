#include "robots/simulation/stock/stock_joints.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace leitstand::simulation {
namespace {

double secondsOf(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

}  // namespace

StockJoints::StockJoints(const RobotDescription& robot) {
    for (const JointGroup& group : robot.jointGroups) {
        for (const MovedJoint& joint : group.joints) {
            m_joints.push_back({joint, group.name});
            m_joints.back().position = joint.within(0.0);
        }
    }
}

StockJoints::Joint* StockJoints::find(const std::string& group, const std::string& name) {
    const auto found = std::find_if(m_joints.begin(), m_joints.end(), [&](const Joint& joint) {
        return joint.group == group && joint.described.name == name;
    });
    return found == m_joints.end() ? nullptr : &*found;
}

void StockJoints::aim(Joint& joint, double target, double within) {
    if (!std::isfinite(target)) return;
    joint.aims = true;
    joint.target = joint.described.within(target);
    joint.within = within;
}

void StockJoints::receive(const std::string& group, const Sample& command) {
    if (const auto* trajectory = command.as<JointTrajectorySample>()) {
        if (trajectory->points.empty()) return;  // refused by joint_trajectory_controller
        const TrajectoryPoint& last = trajectory->points.back();
        for (std::size_t i = 0; i < std::min(last.positions.size(), trajectory->names.size()); ++i) {
            if (Joint* const joint = find(group, trajectory->names[i]))
                aim(*joint, last.positions[i], secondsOf(last.fromStart));
        }
    } else if (const auto* state = command.as<JointSample>()) {
        for (std::size_t i = 0; i < state->names.size(); ++i) {
            Joint* const joint = find(group, state->names[i]);
            if (joint == nullptr) continue;
            if (i < state->positions.size()) aim(*joint, state->positions[i], 0.0);
            if (i < state->velocities.size() && state->positions.empty()) {
                joint->aims = false;
                joint->speed = state->velocities[i];
            }
        }
    } else if (const auto* numbers = command.as<NumbersSample>()) {
        const auto isOurs = [&group](const Joint& joint) { return joint.group == group; };
        const auto count = std::count_if(m_joints.begin(), m_joints.end(), isOurs);
        if (numbers->values.size() != static_cast<std::size_t>(count))
            return;  // as forward_command_controller
        auto value = numbers->values.begin();
        for (Joint& joint : m_joints) {
            if (!isOurs(joint)) continue;
            joint.aims = false;
            joint.speed = *value++;
        }
    }
}

void StockJoints::step(Time now, bool powered) {
    const double seconds = m_now == Time{} ? 0.0 : secondsOf(now - m_now);
    m_now = now;
    if (seconds <= 0.0) return;
    for (Joint& joint : m_joints) {
        if (!powered) {
            joint.aims = false;
            joint.speed = 0.0;
        }
        double velocity = joint.speed;
        if (joint.aims) {
            velocity = (joint.target - joint.position) / std::max(joint.within, seconds);
            joint.within = std::max(0.0, joint.within - seconds);
        }
        constexpr double Spare = 1.2;  // motors are a little faster than what is asked of them
        const double most = Spare * joint.described.rate;
        const double before = joint.position;
        joint.position = joint.described.within(before + std::clamp(velocity, -most, most) * seconds);
        joint.velocity = (joint.position - before) / seconds;
    }
}

void StockJoints::addTo(JointSample& joints) const {
    for (const Joint& joint : m_joints) {
        joints.names.push_back(joint.described.name);
        joints.positions.push_back(joint.position);
        joints.velocities.push_back(joint.velocity);
    }
}

}  // namespace leitstand::simulation
