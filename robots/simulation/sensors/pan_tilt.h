#pragma once

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand::simulation {

/// How far and how fast a pan-tilt unit can turn.
struct PanTiltLimits {
    double pan = degrees(100);      ///< largest pan to each side [rad]
    double tiltUp = degrees(60);    ///< largest tilt upwards [rad]
    double tiltDown = degrees(50);  ///< largest tilt downwards [rad]
    double speed = degrees(120);    ///< speed of each axis [rad/s]
};

/// Angles of a pan-tilt unit, right-handed (REP 103): pan to the left about z, then tilt down about y.
struct PanTiltAngles {
    double pan = 0.0, tilt = 0.0;  ///< [rad]
};

/// A unit that turns a camera: two servos at constant speed.
class PanTilt {
public:
    PanTilt(const PanTiltLimits& limits, Time start) : m_limits(limits), m_before(start), m_now(start) {}

    /// Sets the angles to which it turns [rad], clamped to the limits. Ignores an angle that is not finite.
    void setTarget(double pan, double tilt);
    /// Turns towards the target until @p now.
    void advance(Time now);
    /// Returns the angles at @p time, interpolated between the last two advances. Outside, returns those of
    /// the nearer advance.
    [[nodiscard]] PanTiltAngles at(Time time) const;
    /// Returns how fast the axes turned between the last two advances [rad/s].
    [[nodiscard]] PanTiltAngles velocity() const;
    /// Returns the pose of the tilted platform at @p time, in the frame in which the unit is mounted.
    [[nodiscard]] Pose platform(Time time) const;

private:
    PanTiltLimits m_limits;
    PanTiltAngles m_target, m_anglesBefore, m_angles;
    Time m_before, m_now;
};

}  // namespace leitstand::simulation
