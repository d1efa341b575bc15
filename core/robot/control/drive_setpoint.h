#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// How a robot is to move, in its base frame.
struct DriveVelocity {
    double forward = 0.0;  ///< [m/s]
    double left = 0.0;     ///< [m/s]; omnidirectional robots only
    double turn = 0.0;     ///< counter-clockwise [rad/s]
    friend bool operator==(const DriveVelocity&, const DriveVelocity&) = default;
};
[[nodiscard]] inline bool isZero(const DriveVelocity& velocity) {
    return velocity == DriveVelocity{};
}

/// How fast a robot may move. A limit of 0, or one that is no number, forbids the motion.
struct DriveLimits {
    double speed = 0.0;     ///< of forward and left together [m/s]
    double turnRate = 0.0;  ///< [rad/s]
    bool sideways = false;  ///< whether it can move to the left
};
[[nodiscard]] DriveLimits limitsOf(const RobotDescription& robot);

/// @p velocity within @p limits, its direction kept; zero when any of its numbers is none.
[[nodiscard]] DriveVelocity limited(const DriveVelocity& velocity, const DriveLimits& limits);

/// Distance between the tracks of @p robot, as its footprint is wide [m].
[[nodiscard]] double trackDistance(const RobotDescription& robot);
/// Speeds of the left and right track [m/s], and back.
[[nodiscard]] std::pair<double, double> tracksOf(const DriveVelocity& velocity, double distance);
[[nodiscard]] DriveVelocity velocityOf(std::pair<double, double> tracks, double distance);

/// Our robots stand when no drive command came for so long, and a command is sent to live no longer. Fixed:
/// commands come every 50 ms, so three of them in a row may be lost.
inline constexpr std::chrono::milliseconds DriveWatchdog(200);

/// A setpoint that expired so long ago is forgotten: motion begins again with neutral sticks only. A shorter
/// gap is a hiccup, which sticks that are held outlast.
inline constexpr std::chrono::milliseconds SetpointForgotten(500);

/// What the operator's sticks ask of a robot (design, sections 4 and 7): the newest counts, for 200 ms. Pure.
///
/// Without permission (no focus, no grant, stopped) it is zero, and once there is permission again it stays
/// zero until a zero was set: sticks must be neutral first. The same holds when nothing was set for so long
/// that the last setpoint is forgotten: a station that hung must not move the robot when it is back.
class DriveSetpoint {
public:
    explicit DriveSetpoint(const DriveLimits& limits, std::chrono::nanoseconds lifetime = DriveWatchdog);

    /// The sticks as they are at @p now; to be set again and again while they are held. @p withoutEyes: the
    /// driver holds the override of the speed cap.
    void set(const DriveVelocity& velocity, SteadyTime now, bool withoutEyes = false);
    void permit(bool permitted);
    void halt() { m_neutral = false; }  ///< zero until the sticks were neutral

    [[nodiscard]] DriveVelocity at(SteadyTime now) const;
    [[nodiscard]] bool isFresh(SteadyTime now) const;  ///< permitted, and set within its lifetime
    /// Whether the override is held: it ends with the sticks that told it.
    [[nodiscard]] bool withoutEyes(SteadyTime now) const { return isFresh(now) && m_withoutEyes; }
    [[nodiscard]] const DriveLimits& limits() const { return m_limits; }
    /// When what was set last is too old.
    [[nodiscard]] SteadyTime expires() const { return m_set + m_lifetime; }
    /// Permission is there, but the sticks have not been neutral since.
    [[nodiscard]] bool waitsForNeutral() const { return m_permitted && !m_neutral; }

private:
    DriveLimits m_limits;
    std::chrono::nanoseconds m_lifetime;
    DriveVelocity m_velocity;
    SteadyTime m_set = {};
    bool m_any = false, m_permitted = false, m_neutral = false, m_withoutEyes = false;
};

}  // namespace leitstand
