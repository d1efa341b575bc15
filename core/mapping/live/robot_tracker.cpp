#include "core/mapping/live/robot_tracker.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/event/motion_samples.h"
#include "core/mapping/placement/placement_format.h"

namespace leitstand {
namespace {

constexpr double FirstSpacing = 0.099;      ///< of a trail [m]
constexpr std::size_t LongestTrail = 4000;  ///< points; beyond, every other one is removed

}  // namespace

RobotTracker::RobotTracker(std::string robot) : m_spacing(FirstSpacing) {
    m_now.robot = std::move(robot);
}

void RobotTracker::add(const OdometrySample& odometry, Time now) {
    OdometrySample stamped = odometry;
    if (stamped.header.stamp == Time{}) stamped.header.stamp = now;
    const int jumps = m_motion.clockJumps();
    m_motion.add(stamped);
    if (m_motion.clockJumps() != jumps) m_newest.reset();
    if (!m_motion.covers(stamped.header.stamp) || (m_newest && stamped.header.stamp < *m_newest)) return;
    m_newest = stamped.header.stamp;
    if (m_waiting) {
        m_frame = m_motion.frameAt(*m_newest);
        if (const auto motion = m_motion.at(*m_newest))
            m_now.odomInMap = *std::exchange(m_waiting, std::nullopt) * motion->baseInOdom.inverse();
    }
    refresh();
    leaveTrail();
}

void RobotTracker::add(const ImuSample& imu, const Pose& unitInBase, Time now) {
    ImuSample stamped = imu;
    if (stamped.header.stamp == Time{}) stamped.header.stamp = now;
    m_motion.add(stamped, unitInBase);
}

void RobotTracker::correct(const MapFix& fix) {
    m_waiting.reset();
    const auto motion = m_motion.at(fix.stamp);
    const int frame = m_motion.frameAt(fix.stamp);
    if (motion && m_newest) {
        m_now.odomInMap = fix.baseInMap * motion->baseInOdom.inverse();
        m_frame = frame;
    } else {
        m_now.odomInMap.reset();
        m_waiting = m_now.baseInMap = fix.baseInMap;
    }
    m_now.placed = true;
    m_now.certainty = fix.certainty;
    m_now.certain = fix.certain;
    m_now.how = fix.how;
    refresh();
    publishGap();
}

void RobotTracker::lose() {
    m_now.odomInMap.reset();
    m_waiting.reset();
    m_now.placed = m_now.certain = false;
    m_now.certainty = 0.0;
    m_now.how.clear();
}

std::optional<Pose> RobotTracker::baseInMap(Time stamp) const {
    if (!m_now.odomInMap || m_motion.frameAt(stamp) != m_frame) return std::nullopt;
    const auto motion = m_motion.at(stamp);
    if (!motion) return std::nullopt;
    return *m_now.odomInMap * motion->baseInOdom;
}

void RobotTracker::refresh() {
    if (!m_newest) return;
    m_now.stamp = *m_newest;
    if (!m_now.odomInMap) return;
    if (m_motion.frameAt(*m_newest) != m_frame) {
        // It stays where it was seen last, and continues from there by the odometry that restarted.
        m_waiting = m_now.baseInMap;
        m_now.odomInMap.reset();
        m_now.certain = false;
        m_now.certainty = 0.0;
        m_now.how = logged(placement_format::OdometryRestarted);
        return;
    }
    if (const auto here = baseInMap(*m_newest)) m_now.baseInMap = *here;
}

void RobotTracker::leaveTrail() {
    if (!m_now.odomInMap) return;
    if (m_followed)
        m_notReceived = std::max(m_notReceived, std::chrono::nanoseconds(m_now.stamp - *m_followed));
    m_followed = m_now.stamp;
    const Eigen::Vector3d here = m_now.baseInMap.translation();
    if (!m_trail.empty() &&
        (here.cast<float>() - m_trail.back().inMap).norm() < static_cast<float>(m_spacing))
        return publishGap();
    m_trail.push_back(
        {here.cast<float>(), m_now.odomInMap->inverse() * here, m_now.stamp, m_frame, m_notReceived});
    m_notReceived = {};
    if (m_trail.size() > LongestTrail) {
        for (std::size_t i = 0; 2 * i < m_trail.size(); ++i) {
            const auto left = i > 0 ? m_trail[2 * i - 1].notReceived : std::chrono::nanoseconds{};
            m_trail[i] = m_trail[2 * i];
            m_trail[i].notReceived = std::max(m_trail[i].notReceived, left);
        }
        m_trail.erase(m_trail.begin() + static_cast<std::ptrdiff_t>((m_trail.size() + 1) / 2), m_trail.end());
        m_spacing *= 2.0;
    }
    publishTrail();
}

void RobotTracker::layTrail(std::span<const TrailAnchor> anchors) {
    for (Footstep& step : m_trail) {
        const TrailAnchor* newest = nullptr;
        for (const TrailAnchor& anchor : anchors) {
            const bool before = anchor.frame == step.frame && anchor.since <= step.stamp;
            if (before && (newest == nullptr || anchor.since > newest->since)) newest = &anchor;
        }
        if (newest != nullptr) step.inMap = (newest->odomInMap * step.inOdom).cast<float>();
    }
    if (!m_trail.empty()) publishTrail();
}

void RobotTracker::move(const MovedPlaces& places) {
    const Pose correction = places.at(m_now.baseInMap.translation());
    for (Footstep& step : m_trail) {
        const Eigen::Vector3d was = step.inMap.cast<double>();
        step.inMap = (places.at(was) * was).cast<float>();
    }
    m_now.baseInMap = correction * m_now.baseInMap;
    if (m_now.odomInMap) m_now.odomInMap = correction * *m_now.odomInMap;
    if (m_waiting) m_waiting = correction * *m_waiting;
    if (!m_trail.empty()) publishTrail();
}

void RobotTracker::publishTrail() {
    auto trail = std::make_shared<Trail>();
    trail->reserve(m_trail.size());
    for (const Footstep& step : m_trail) {
        const float away = trail->empty() ? 0.0F : (step.inMap - trail->back().inMap).norm();
        trail->push_back({step.inMap, isGap(static_cast<double>(away), step.notReceived, m_spacing)});
    }
    m_now.trail = std::move(trail);
    publishGap();
}

void RobotTracker::publishGap() {
    if (m_trail.empty()) return;
    const Eigen::Vector3d end = m_trail.back().inMap.cast<double>();
    m_now.afterGap = isGap((m_now.baseInMap.translation() - end).norm(), m_notReceived, m_spacing);
}

}  // namespace leitstand
