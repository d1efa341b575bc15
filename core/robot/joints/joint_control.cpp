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

constexpr auto Lifetime = 200ms;      ///< of a motion by hand that is not renewed
constexpr auto Fresh = 1s;            ///< of a reported position
constexpr auto LongestStep = 100ms;   ///< of a target: after a pause it does not jump
constexpr auto HoldFor = 500ms;       ///< during a stop
constexpr auto ZerosFor = 500ms;      ///< at least, after a motion
constexpr auto ZerosAtMost = 5s;      ///< of joints that are not seen to stand: others may move them
constexpr auto StandsAfter = 200ms;   ///< without another position
constexpr auto EndFor = 300ms;        ///< positions after a motion
constexpr auto SameMotion = 300ms;    ///< after which targets no longer count
constexpr auto Patience = 3s;         ///< with a preset that comes no nearer
constexpr double LongestLead = 0.5;   ///< of a target ahead of its joint, in seconds of the joint's rate
constexpr double UsualLead = 0.15;    ///< of a target whose joint follows
constexpr double SlowsWithin = 0.5;   ///< of a preset, by velocities: seconds of the joint's rate
constexpr double StandsWithin = 0.1;  ///< of a report to the next, in parts of what counts as reached
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
        Joint& joint = m_joints[*at];
        const double still = StandsWithin * reachedWithin(m_group.joints[*at]);
        if (!joint.position || std::abs(*joint.position - joints.positions[i]) > still) joint.moved = now;
        joint.position = joints.positions[i];
        joint.reported = now;
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

bool JointControl::stands(SteadyTime now) const {
    return std::all_of(m_joints.begin(), m_joints.end(), [now](const Joint& joint) {
        if (!joint.position) return true;  // never reported: it cannot be seen
        return now - joint.reported <= Fresh && now - joint.moved > StandsAfter;
    });
}

void JointControl::end(SteadyTime now, JointMotion why) {
    if (moves()) {
        m_ending = true;
        m_ended = now;
        for (std::size_t i = 0; i < m_joints.size(); ++i) {
            // One that follows comes to its target; another one would go on, or press.
            Joint& joint = m_joints[i];
            const auto at = position(i, now);
            const double lead = UsualLead * m_group.joints[i].rate;
            if (at && joint.target && std::abs(*joint.target - *at) > lead) joint.target = at;
        }
    }
    m_motion = why;
    m_preset.reset();
    m_share = 0.0;
}

void JointControl::begin(SteadyTime now) {
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        Joint& joint = m_joints[i];
        const double at = *position(i, now), lead = LongestLead * m_group.joints[i].rate;
        // A joint that still goes to its last target keeps that, so that it does not stop and start again.
        const bool same = joint.target && now - m_sent <= SameMotion;
        if (!same || std::abs(*joint.target - at) > lead) joint.target = at;
    }
}

void JointControl::move(std::size_t axis, double share, SteadyTime now) {
    if (axis >= m_group.axes.size()) return;
    share = std::isfinite(share) ? std::clamp(share, -1.0, 1.0) : 0.0;
    if (share == 0.0) {
        m_needsRest = false;
        if (m_motion == JointMotion::ByHand) end(now);
        return;
    }
    if (m_needsRest) return;
    m_renewed = now;
    m_axis = axis;
    m_share = share;
    if (m_motion == JointMotion::ByHand) return;
    m_preset.reset();
    const bool blind = m_group.mode == JointCommandMode::Velocity;  // goes without positions
    if (!blind && !isKnown(now)) return end(now, JointMotion::Unreported);
    m_motion = JointMotion::ByHand;
    m_ending = false;
    if (!blind) begin(now);
}

void JointControl::goTo(std::size_t preset, SteadyTime now) {
    if (preset >= m_group.presets.size()) return;
    end(now);
    if (!isKnown(now)) return end(now, JointMotion::Unreported);
    m_preset = preset;
    m_motion = JointMotion::ToPreset;
    m_ending = false;
    m_nearer = now;
    m_nearest = std::numeric_limits<double>::infinity();
    begin(now);
}

void JointControl::halt() {
    end(m_due);
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

std::optional<JointSetpoints> JointControl::targets() const {
    JointSetpoints all;
    for (const Joint& joint : m_joints) {
        const std::optional<double> target = joint.target ? joint.target : joint.position;
        if (!target) return std::nullopt;
        all.values.push_back(*target);
    }
    return all;
}

JointSetpoints JointControl::zeros() const {
    return {JointCommandMode::Velocity, std::vector<double>(m_joints.size(), 0.0)};
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
    if (m_group.mode == JointCommandMode::Velocity) return zeros();
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
    const auto refuse = [&] {
        end(now, JointMotion::Unreported);
        m_needsRest = true;
        return std::nullopt;
    };
    if (m_group.mode == JointCommandMode::Position) {
        if (!isKnown(now)) return refuse();
        for (const std::size_t i : axis.joints) {
            const MovedJoint& joint = m_group.joints[i];
            const double from = m_joints[i].target.value_or(*m_joints[i].position);
            lead(i, from + m_share * upOf(joint) * joint.rate * seconds, now);
        }
        m_sent = now;
        return targets();
    }
    JointSetpoints all = zeros();
    for (const std::size_t i : axis.joints) {
        const MovedJoint& joint = m_group.joints[i];
        const double velocity = m_share * upOf(joint) * joint.rate;
        const auto at = position(i, now);
        // One that was reported has its limits; without its position it would run into them.
        if (!at && m_joints[i].position && (joint.lower || joint.upper)) return refuse();
        const bool ends = at && ((velocity > 0.0 && joint.upper && *at >= *joint.upper) ||
                                 (velocity < 0.0 && joint.lower && *at <= *joint.lower));
        all.values[i] = ends ? 0.0 : velocity;
    }
    return all;
}

std::optional<JointSetpoints> JointControl::toPreset(double seconds, SteadyTime now) {
    if (!isKnown(now)) {
        end(now, JointMotion::Unreported);
        return std::nullopt;
    }
    double left = 0.0;
    bool reached = true;
    JointSetpoints velocities = zeros();
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        const MovedJoint& joint = m_group.joints[i];
        const double to = goal(i), error = to - *m_joints[i].position;
        const double step = joint.rate * seconds;
        const double from = m_joints[i].target.value_or(*m_joints[i].position);
        lead(i, from + std::clamp(to - from, -step, step), now);
        left += std::abs(error) / reachedWithin(joint);
        if (std::abs(error) <= reachedWithin(joint)) continue;
        reached = false;
        velocities.values[i] = std::clamp(error / SlowsWithin, -joint.rate, joint.rate);
    }
    if (left < m_nearest - 0.5) {  // half of what counts as reached
        m_nearest = left;
        m_nearer = now;
    }
    if (reached || now - m_nearer > Patience) {
        end(now, reached ? JointMotion::Still : JointMotion::Blocked);
        return std::nullopt;
    }
    m_sent = now;
    return m_group.mode == JointCommandMode::Position ? targets() : std::optional(velocities);
}

std::optional<JointSetpoints> JointControl::ending(const JointConditions& conditions, SteadyTime now) {
    if (!m_ending) return std::nullopt;
    if (!conditions.heard) m_ended = now;  // nothing arrives: it is said once the link is back
    const auto since = now - m_ended;
    if (m_group.mode == JointCommandMode::Velocity) {
        m_ending = since <= ZerosFor || (since <= ZerosAtMost && !stands(now));
        return m_ending ? std::optional(zeros()) : std::nullopt;
    }
    // Without the grant once, lest it disturbs who has it now.
    m_ending = conditions.mayMove && since <= EndFor;
    return targets();
}

std::optional<JointSetpoints> JointControl::due(const JointConditions& conditions, SteadyTime now) {
    const double seconds = m_due == SteadyTime{} ? 0.0 : secondsOf(now - m_due);
    m_due = now;
    if (!conditions.mayMove || conditions.hold) {
        end(now);
        m_needsRest = true;
    }
    if (conditions.hold) {
        (void)ending(conditions, now);  // what holds them says it; only until when counts
        return held(now);
    }
    if (m_heldSince) {
        // Nothing goes on from before the stop, or begins in its last moment.
        end(now);
        m_needsRest = true;
        m_heldSince.reset();
        m_ending = m_ending && m_group.mode == JointCommandMode::Velocity;
        for (Joint& joint : m_joints) joint.target.reset();
    }
    if (m_motion == JointMotion::ByHand && now - m_renewed > Lifetime) {
        end(now);
        m_needsRest = true;
    }
    std::optional<JointSetpoints> sent;
    if (m_motion == JointMotion::ByHand) sent = byHand(seconds, now);
    if (m_motion == JointMotion::ToPreset) sent = toPreset(seconds, now);
    return moves() ? sent : ending(conditions, now);
}

}  // namespace leitstand
