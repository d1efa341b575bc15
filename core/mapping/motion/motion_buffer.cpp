#include "core/mapping/motion/motion_buffer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/rotation/heading.h"
#include "core/base/time.h"
#include "core/event/motion_samples.h"

namespace leitstand {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds BackwardStep(500);         ///< stamps that go back farther are a clock jump
constexpr std::chrono::seconds ForwardStep(5);    ///< stamps that go ahead farther are doubted at first
constexpr milliseconds StrayFits(1000);           ///< a doubted stamp is right if the next one is so near
constexpr double FastestMove = 4.0, Leap = 0.3;   ///< a robot moves no farther in a time [m/s], [m] ...
constexpr double FastestTurn = 8.0, Swing = 0.5;  ///< ... and turns no farther [rad/s], [rad]
constexpr milliseconds SpeedOver(80);             ///< least time over which the present speed is measured

/// Moves @p b on by @p share times the motion from @p a to @p b; the share may be above 1. The @p turn about
/// its own upright axis replaces the motion's [rad].
Pose continued(const Pose& a, const Pose& b, double share, const std::optional<double>& turn) {
    const Pose step = a.inverse() * b;
    const Eigen::AngleAxisd turned(step.linear());
    Eigen::Vector3d rotation = share * turned.angle() * turned.axis();
    if (turn) rotation.z() = *turn;
    Eigen::Matrix<double, 6, 1> twist;
    twist << share * step.translation(), rotation;
    return b * poseFromTwist(twist);
}

Pose turnedBy(Pose pose, double heading) {
    pose.linear() = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * pose.linear();
    return pose;
}

}  // namespace

bool leaps(const Pose& a, const Pose& b, double time) {
    return distanceBetween(a, b) > FastestMove * time + Leap ||
           angleBetween(a, b) > FastestTurn * time + Swing;
}

void MotionBuffer::keep(Time stamp, const Pose& baseInOdom) {
    const auto at = std::upper_bound(m_entries.begin(), m_entries.end(), stamp,
                                     [](Time wanted, const Entry& entry) { return wanted < entry.stamp; });
    if (at == m_entries.end() && !m_entries.empty()) {
        const Entry& last = m_entries.back();
        if (stamp == last.stamp) return;
        if (leaps(last.baseInOdom, baseInOdom, toSeconds(stamp - last.stamp))) ++m_frame;
    } else if (at != m_entries.begin() && std::prev(at)->stamp == stamp) {
        return;
    }
    // A sample that is out of order belongs to the frame of its neighbours.
    const int frame = at == m_entries.end() ? m_frame : at->frame;
    m_entries.insert(at, {stamp, baseInOdom, frame});
    while (m_entries.size() > 2 && m_entries.back().stamp - m_entries.front().stamp > Memory)
        m_entries.pop_front();
}

void MotionBuffer::add(const OdometrySample& odometry) {
    if (!odometry.baseInOdom.matrix().allFinite()) return;
    const Time stamp = odometry.header.stamp;
    if (!m_entries.empty()) {
        const Time newest = m_entries.back().stamp;
        const bool back = stamp<newest - BackwardStep, ahead = stamp> newest + ForwardStep;
        if (back || ahead) {
            const bool confirmed = m_stray && stamp >= m_stray->stamp && stamp - m_stray->stamp <= StrayFits;
            if (!confirmed) {
                m_stray = Entry{stamp, odometry.baseInOdom, 0};
                return;
            }
            if (back) {
                const Pose before = m_entries.back().baseInOdom;
                ++m_clockJumps;
                m_entries.clear();
                m_level.clear();
                m_gyro.clear();
                if (leaps(before, m_stray->baseInOdom, 1.0)) ++m_frame;
            }
            keep(m_stray->stamp, m_stray->baseInOdom);
        }
        m_stray.reset();
    }
    keep(stamp, odometry.baseInOdom);
    m_level.forgetBefore(m_entries.front().stamp);
    m_gyro.forgetBefore(m_entries.front().stamp);
}

void MotionBuffer::add(const ImuSample& imu, const Pose& unitInBase) {
    const Eigen::Matrix3d& inBase = unitInBase.linear();
    std::optional<Eigen::Vector3d> up, turning;
    if (imu.orientation) {
        up = inBase * (imu.orientation->conjugate() * Eigen::Vector3d::UnitZ());
    } else if (imu.linearAcceleration) {
        up = inBase * *imu.linearAcceleration;
    }
    if (imu.angularVelocity) turning = inBase * *imu.angularVelocity;
    m_level.add(imu.header.stamp, up, turning);
    const auto newest = m_level.newest();
    m_hasUnit = m_hasUnit || newest;
    if (turning)
        m_gyro.add(imu.header.stamp,
                   turning->dot(m_level.at(imu.header.stamp).value_or(Eigen::Vector3d::UnitZ())));
    // Without odometry nothing else forgets old measurements.
    const Time now = newest.value_or(imu.header.stamp);
    if (m_entries.empty() || now - m_entries.back().stamp > Memory) {
        m_level.forgetBefore(now - Memory);
        m_gyro.forgetBefore(now - Memory);
    }
}

std::deque<MotionBuffer::Entry>::const_iterator MotionBuffer::after(Time stamp) const {
    return std::lower_bound(m_entries.begin(), m_entries.end(), stamp,
                            [](const Entry& entry, Time wanted) { return entry.stamp < wanted; });
}

Pose MotionBuffer::levelled(Pose baseInOdom, Time stamp) const {
    const auto up = m_level.at(stamp);
    if (!up) return baseInOdom;
    const double pitch = std::asin(std::clamp(-up->x(), -1.0, 1.0)), roll = std::atan2(up->y(), up->z());
    return poseFrom(baseInOdom.translation(), roll, pitch, headingOf(baseInOdom));
}

std::optional<Motion> MotionBuffer::beyond(Time stamp) const {
    const Entry& last = m_entries.back();
    const auto ahead = stamp - last.stamp;
    if (ahead > LongestGuess) return std::nullopt;
    auto before = std::prev(m_entries.end());
    while (before != m_entries.begin() && last.stamp - before->stamp < SpeedOver) --before;
    const auto over = last.stamp - before->stamp;
    Motion motion{last.baseInOdom, MotionSource::Extrapolated};
    if (over >= SpeedOver && over <= LongestStep && before->frame == last.frame)
        motion.baseInOdom = continued(before->baseInOdom, last.baseInOdom, toSeconds(ahead) / toSeconds(over),
                                      m_gyro.turned(last.stamp, stamp));
    motion.baseInOdom = levelled(motion.baseInOdom, stamp);
    return motion;
}

std::optional<Motion> MotionBuffer::at(Time stamp) const {
    if (m_entries.empty()) return std::nullopt;
    const auto next = after(stamp);
    if (next == m_entries.end()) return beyond(stamp);
    if (next->stamp == stamp) return Motion{levelled(next->baseInOdom, stamp), MotionSource::Measured};
    if (next == m_entries.begin()) {
        if (next->stamp - stamp > LongestStep) return std::nullopt;
        return Motion{levelled(next->baseInOdom, stamp), MotionSource::Extrapolated};
    }
    const auto before = std::prev(next);
    const auto step = next->stamp - before->stamp;
    if (before->frame != next->frame || step > LongestBridge) {
        // The frames are unrelated: the nearer pose counts.
        const bool first = stamp - before->stamp <= next->stamp - stamp;
        const Entry& nearer = first ? *before : *next;
        if ((first ? stamp - before->stamp : next->stamp - stamp) > LongestStep) return std::nullopt;
        return Motion{levelled(nearer.baseInOdom, stamp), MotionSource::Extrapolated};
    }
    const Pose pose = interpolated(before->baseInOdom, next->baseInOdom,
                                   toSeconds(stamp - before->stamp) / toSeconds(step));
    if (step <= LongestStep) return Motion{levelled(pose, stamp), MotionSource::Measured};
    return Motion{levelled(turnedByGyro(pose, *before, *next, stamp), stamp), MotionSource::Bridged};
}

Pose MotionBuffer::turnedByGyro(const Pose& pose, const Entry& before, const Entry& after, Time stamp) const {
    const auto soFar = m_gyro.turned(before.stamp, stamp), whole = m_gyro.turned(before.stamp, after.stamp);
    if (!soFar || !whole) return pose;
    // The drift of the gyros shows at the end, where odometry measures the heading.
    const double begin = headingOf(before.baseInOdom);
    const double drift = std::remainder(headingOf(after.baseInOdom) - begin - *whole, 2.0 * std::numbers::pi);
    const double share = toSeconds(stamp - before.stamp) / toSeconds(after.stamp - before.stamp);
    return turnedBy(pose, begin + *soFar + share * drift - headingOf(pose));
}

Travel MotionBuffer::travelled(Time from, Time to) const {
    Travel travel;
    if (!(from < to)) return travel;
    const auto last = after(to);
    for (auto entry = after(from); entry != last && std::next(entry) != last; ++entry) {
        const Entry& next = *std::next(entry);
        if (next.frame != entry->frame) continue;
        travel.way += distanceBetween(entry->baseInOdom, next.baseInOdom);
        travel.turn += std::abs(headingOf(entry->baseInOdom.linear().transpose() * next.baseInOdom.linear()));
    }
    return travel;
}

bool MotionBuffer::covers(Time stamp) const {
    return !m_entries.empty() && m_entries.back().stamp >= stamp;
}

int MotionBuffer::frameAt(Time stamp) const {
    const auto next = after(stamp);
    if (next == m_entries.end()) return m_frame;
    if (next == m_entries.begin()) return next->frame;
    const auto before = std::prev(next);
    return stamp - before->stamp <= next->stamp - stamp ? before->frame : next->frame;
}

}  // namespace leitstand
