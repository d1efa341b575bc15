#include "core/robot/joints/joint_control.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/pose.h"
#include "core/event/motion_samples.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

constexpr auto Lifetime = 200ms;     ///< of a motion by hand that is not renewed
constexpr auto Fresh = 1s;           ///< of a reported position
constexpr auto LongestStep = 100ms;  ///< of a target: after a pause it does not jump
constexpr auto HoldFor = 500ms;      ///< during a stop
constexpr auto ZerosFor = 500ms;     ///< after a motion
constexpr auto Patience = 3s;        ///< with a preset that comes no nearer
constexpr double LongestLead = 0.5;  ///< of a target ahead of its joint, in seconds of the joint's rate
constexpr double SlowsWithin = 0.5;  ///< of a preset, by velocities: seconds of the joint's rate
constexpr double ReachedAngle = degrees(1.5), ReachedLength = 0.005;

double reachedWithin(const MovedJoint& joint) {
    return joint.type == JointType::Revolute ? ReachedAngle : ReachedLength;
}

double secondsOf(SteadyTime::duration step) {
    return std::chrono::duration<double>(std::clamp<SteadyTime::duration>(step, 0ms, LongestStep)).count();
}

/// Up, in the joint's own direction.
double upOf(const MovedJoint& joint) {
    return joint.reversed ? -1.0 : 1.0;
}

}  // namespace

JointControl::JointControl(JointGroup group) : m_group(std::move(group)), m_joints(m_group.joints.size()) {}

void JointControl::reported(const JointSample& joints, SteadyTime now) {
    for (std::size_t i = 0; i < std::min(joints.names.size(), joints.positions.size()); ++i) {
        const auto at = m_group.indexOf(joints.names[i]);
        if (!at || !std::isfinite(joints.positions[i])) continue;
        m_joints[*at].position = joints.positions[i];
        m_joints[*at].reported = now;
    }
}

std::optional<double> JointControl::position(std::size_t joint, SteadyTime now) const {
    const Joint& one = m_joints.at(joint);
    return one.position && now - one.reported <= Fresh ? one.position : std::nullopt;
}

bool JointControl::isKnown(SteadyTime now) const {
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        if (!position(i, now)) return false;
    }
    return true;
}

void JointControl::end(JointMotion why) {
    m_motion = why;
    m_preset.reset();
    m_share = 0.0;
}

void JointControl::begin(SteadyTime now) {
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        Joint& joint = m_joints[i];
        const double at = *position(i, now), lead = LongestLead * m_group.joints[i].rate;
        // A joint that still goes to its last target keeps that, so that it does not stop and start again.
        if (!joint.target || std::abs(*joint.target - at) > lead) joint.target = at;
    }
}

void JointControl::move(std::size_t axis, double share, SteadyTime now) {
    if (axis >= m_group.axes.size()) return;
    share = std::isfinite(share) ? std::clamp(share, -1.0, 1.0) : 0.0;
    if (share == 0.0) {
        m_needsRest = false;
        if (m_motion == JointMotion::ByHand) {
            end();
            m_ended = now;
        }
        return;
    }
    if (m_needsRest) return;
    m_renewed = now;
    m_axis = axis;
    m_share = share;
    if (m_motion == JointMotion::ByHand) return;
    m_preset.reset();
    const bool blind = m_group.mode == JointCommandMode::Velocity;  // goes without positions
    if (!blind && !isKnown(now)) {
        end(JointMotion::Unreported);
        return;
    }
    m_motion = JointMotion::ByHand;
    if (!blind) begin(now);
}

void JointControl::goTo(std::size_t preset, SteadyTime now) {
    if (preset >= m_group.presets.size()) return;
    end();
    if (!isKnown(now)) {
        end(JointMotion::Unreported);
        return;
    }
    m_preset = preset;
    m_motion = JointMotion::ToPreset;
    m_nearer = now;
    m_nearest = std::numeric_limits<double>::infinity();
    begin(now);
}

void JointControl::halt() {
    if (isMoving()) {
        end();
        m_ended = m_due;
    }
    m_needsRest = true;
}

double JointControl::goal(std::size_t joint) const {
    const MovedJoint& one = m_group.joints[joint];
    const double asked = m_group.presets[*m_preset].positions[joint];
    if (one.type == JointType::Prismatic || one.lower || one.upper) return one.within(asked);
    // One that turns for ever takes the nearer way.
    const double round = 2.0 * std::numbers::pi;
    const double at = m_joints[joint].position.value_or(asked);
    return asked + round * std::round((at - asked) / round);
}

JointSetpoints JointControl::targets() const {
    JointSetpoints all;
    for (const Joint& joint : m_joints) all.values.push_back(joint.target.value_or(0.0));
    return all;
}

void JointControl::lead(std::size_t joint, double target, SteadyTime now) {
    const MovedJoint& one = m_group.joints[joint];
    if (const auto at = position(joint, now)) {
        const double most = LongestLead * one.rate;
        target = std::clamp(target, *at - most, *at + most);
    }
    m_joints[joint].target = one.within(target);
}

std::optional<JointSetpoints> JointControl::held(SteadyTime now) {
    if (m_group.mode == JointCommandMode::Velocity)
        return JointSetpoints{JointCommandMode::Velocity, std::vector<double>(m_joints.size(), 0.0)};
    if (!m_heldSince) {
        m_heldSince = now;
        for (std::size_t i = 0; i < m_joints.size(); ++i) m_joints[i].target = position(i, now);
    }
    const bool known = std::all_of(m_joints.begin(), m_joints.end(),
                                   [](const Joint& joint) { return joint.target.has_value(); });
    if (!known || now - *m_heldSince > HoldFor) return std::nullopt;
    return targets();
}

std::optional<JointSetpoints> JointControl::byHand(double seconds, SteadyTime now) {
    const JointAxis& axis = m_group.axes[m_axis];
    if (m_group.mode == JointCommandMode::Position) {
        if (!isKnown(now)) {
            end(JointMotion::Unreported);
            m_needsRest = true;
            return std::nullopt;
        }
        for (const std::size_t i : axis.joints) {
            const MovedJoint& joint = m_group.joints[i];
            lead(i, *m_joints[i].target + m_share * upOf(joint) * joint.rate * seconds, now);
        }
        return targets();
    }
    JointSetpoints all{JointCommandMode::Velocity, std::vector<double>(m_joints.size(), 0.0)};
    for (const std::size_t i : axis.joints) {
        const MovedJoint& joint = m_group.joints[i];
        const double velocity = m_share * upOf(joint) * joint.rate;
        const auto at = position(i, now);
        const bool ends = at && ((velocity > 0.0 && joint.upper && *at >= *joint.upper) ||
                                 (velocity < 0.0 && joint.lower && *at <= *joint.lower));
        all.values[i] = ends ? 0.0 : velocity;
    }
    return all;
}

std::optional<JointSetpoints> JointControl::toPreset(double seconds, SteadyTime now) {
    if (!isKnown(now)) {
        end(JointMotion::Unreported);
        return atRest(now);
    }
    double left = 0.0;
    bool reached = true;
    JointSetpoints velocities{JointCommandMode::Velocity, std::vector<double>(m_joints.size(), 0.0)};
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        const MovedJoint& joint = m_group.joints[i];
        const double to = goal(i), error = to - *m_joints[i].position;
        const double step = joint.rate * seconds;
        lead(i, *m_joints[i].target + std::clamp(to - *m_joints[i].target, -step, step), now);
        left += std::abs(error) / reachedWithin(joint);
        if (std::abs(error) <= reachedWithin(joint)) continue;
        reached = false;
        velocities.values[i] = std::clamp(error / SlowsWithin, -joint.rate, joint.rate);
    }
    if (left < m_nearest - 0.5) {  // half of what counts as reached
        m_nearest = left;
        m_nearer = now;
    }
    const JointSetpoints last = m_group.mode == JointCommandMode::Position ? targets() : velocities;
    if (reached || now - m_nearer > Patience) {
        end(reached ? JointMotion::Still : JointMotion::Blocked);
        m_ended = now;
        // What is blocked does not go on pressing.
        if (!reached && m_group.mode == JointCommandMode::Position) {
            for (std::size_t i = 0; i < m_joints.size(); ++i) m_joints[i].target = m_joints[i].position;
            return targets();
        }
        return m_group.mode == JointCommandMode::Velocity ? atRest(now) : std::optional(last);
    }
    return last;
}

std::optional<JointSetpoints> JointControl::atRest(SteadyTime now) {
    if (m_group.mode == JointCommandMode::Position || m_ended == SteadyTime{} || now - m_ended > ZerosFor)
        return std::nullopt;
    return JointSetpoints{JointCommandMode::Velocity, std::vector<double>(m_joints.size(), 0.0)};
}

std::optional<JointSetpoints> JointControl::due(const JointConditions& conditions, SteadyTime now) {
    const double seconds = m_due == SteadyTime{} ? 0.0 : secondsOf(now - m_due);
    m_due = now;
    if (!conditions.mayMove || conditions.hold) {
        if (isMoving()) {
            end();
            m_ended = now;
        }
        m_needsRest = true;
    }
    if (conditions.hold) return held(now);
    if (!conditions.mayMove || m_heldSince) {
        for (Joint& joint : m_joints) joint.target.reset();  // others may have moved them
    }
    m_heldSince.reset();
    if (!conditions.mayMove) return atRest(now);
    if (m_motion == JointMotion::ByHand && now - m_renewed > Lifetime) {
        end();
        m_ended = now;
        m_needsRest = true;
    }
    if (m_motion == JointMotion::ByHand) return byHand(seconds, now);
    if (m_motion == JointMotion::ToPreset) return toPreset(seconds, now);
    return atRest(now);
}

}  // namespace leitstand
