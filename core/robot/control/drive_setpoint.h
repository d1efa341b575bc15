#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Wanted velocity of a robot, in its base frame.
struct DriveVelocity {
    double forward = 0.0;  ///< [m/s]
    double left = 0.0;     ///< [m/s]; omnidirectional robots only
    double turn = 0.0;     ///< turn rate, counter-clockwise [rad/s]
    friend bool operator==(const DriveVelocity&, const DriveVelocity&) = default;
};
[[nodiscard]] inline bool isZero(const DriveVelocity& velocity) {
    return velocity == DriveVelocity{};
}

/// Speed limits of a robot. If a limit is 0 or not a number, that motion is forbidden.
struct DriveLimits {
    double speed = 0.0;     ///< limit for forward and left together [m/s]
    double turnRate = 0.0;  ///< [rad/s]
    bool sideways = false;  ///< whether it can move sideways
};
[[nodiscard]] DriveLimits limitsOf(const RobotDescription& robot);

/// Returns @p velocity within @p limits: forward and left are scaled together, turn is limited separately.
/// Zero when a number is not finite.
[[nodiscard]] DriveVelocity limited(const DriveVelocity& velocity, const DriveLimits& limits);

/// Distance between the tracks of @p robot: the width of its footprint [m].
[[nodiscard]] double trackDistance(const RobotDescription& robot);
/// Converts to speeds of the left and right track [m/s], and back. @p distance: trackDistance() [m].
[[nodiscard]] std::pair<double, double> tracksOf(const DriveVelocity& velocity, double distance);
[[nodiscard]] DriveVelocity velocityOf(std::pair<double, double> tracks, double distance);

/// Our robots stop when they have received no drive command for this long; a command has the same lifetime.
/// Not configurable: commands are sent every 25 ms, so seven in a row may be lost.
inline constexpr std::chrono::milliseconds DriveWatchdog(200);

/// If a setpoint expired this long ago, motion starts again only after the sticks were neutral. After a
/// shorter gap, sticks that are still held are obeyed.
inline constexpr std::chrono::milliseconds SetpointForgotten(500);

/// The operator's setpoint for a robot (docs/design.md, "The wire" and "The window"): the newest one is valid
/// for 200 ms. Pure.
///
/// Without permission (no focus, no grant, stopped) the setpoint is zero. When permission is given again, it
/// stays zero until a zero was set: the sticks must be neutral first. The same holds if the last setpoint
/// expired at least SetpointForgotten ago: a station that hung must not move the robot when it continues.
class DriveSetpoint {
public:
    explicit DriveSetpoint(const DriveLimits& limits, std::chrono::nanoseconds lifetime = DriveWatchdog);

    /// Sets the sticks at @p now; call it repeatedly while they are held. @p withoutEyes: whether the driver
    /// holds the override of the speed cap.
    void set(const DriveVelocity& velocity, SteadyTime now, bool withoutEyes = false);
    void permit(bool permitted);
    void halt() { m_neutral = false; }  ///< sets zero until the sticks were neutral

    [[nodiscard]] DriveVelocity at(SteadyTime now) const;
    /// Whether driving is permitted, and the setpoint has not expired.
    [[nodiscard]] bool isFresh(SteadyTime now) const;
    /// Whether the override of the speed cap is held. It ends together with the setpoint that it belongs to.
    [[nodiscard]] bool withoutEyes(SteadyTime now) const { return isFresh(now) && m_withoutEyes; }
    [[nodiscard]] const DriveLimits& limits() const { return m_limits; }
    /// When the last setpoint expires.
    [[nodiscard]] SteadyTime expires() const { return m_set + m_lifetime; }
    /// Whether driving is permitted, but the sticks have not been neutral since.
    [[nodiscard]] bool waitsForNeutral() const { return m_permitted && !m_neutral; }

private:
    DriveLimits m_limits;
    std::chrono::nanoseconds m_lifetime;
    DriveVelocity m_velocity;
    SteadyTime m_set = {};
    bool m_any = false, m_permitted = false, m_neutral = false, m_withoutEyes = false;
};

}  // namespace leitstand
