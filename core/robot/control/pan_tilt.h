#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Angles of a pan-tilt unit (REP 103): pan to the left about z, then tilt down about y.
struct PanTiltAngles {
    double pan = 0.0, tilt = 0.0;  ///< [rad]
    friend bool operator==(const PanTiltAngles&, const PanTiltAngles&) = default;
};

/// Returns @p angles limited to the range of @p mount; an angle that is not finite becomes 0.
[[nodiscard]] PanTiltAngles within(const PanTiltMount& mount, const PanTiltAngles& angles);

/// Returns the angles at which a camera looks towards @p direction, in the frame that its unit is mounted on
/// (x ahead, y left, z up).
[[nodiscard]] PanTiltAngles towards(const Eigen::Vector3d& direction);

/// Returns the angles at which the point that was grabbed in the picture stays under the pointer. @p start:
/// the angles when it was grabbed. @p grabbed and @p pointer: directions of the pointer then and now, in the
/// camera's optical frame (x right, y down, z ahead).
[[nodiscard]] PanTiltAngles dragged(const PanTiltAngles& start, const Eigen::Vector3d& grabbed,
                                    const Eigen::Vector3d& pointer);

/// The operator's control of one pan-tilt unit: its present angles, the requested angles, and what must be
/// sent. Pure: no clock, no thread.
class PanTiltControl {
public:
    explicit PanTiltControl(const PanTiltMount& mount) : m_mount(mount) {}

    /// Takes the angles that the robot's joint states report.
    void reported(const PanTiltAngles& now) { m_now = now; }
    void turnTo(const PanTiltAngles& angles, SteadyTime now);
    /// Turns by @p step from the requested angles. If there are none, turns from the reported angles.
    void turnBy(const PanTiltAngles& step, SteadyTime now);
    /// Turns at @p perSecond [rad/s] until another rate is set. Zero: keeps the angles requested so far.
    void setRate(const PanTiltAngles& perSecond, SteadyTime now);
    /// Returns what to send now, at most 25 times a second. The requested angles are repeated until the unit
    /// has reached them. If they do not change for 5 s without being reached, they are dropped: something
    /// blocks the unit.
    [[nodiscard]] std::optional<PanTiltAngles> due(SteadyTime now);

    [[nodiscard]] const PanTiltMount& mount() const { return m_mount; }
    /// Reported angles; empty: unknown.
    [[nodiscard]] const std::optional<PanTiltAngles>& now() const { return m_now; }
    [[nodiscard]] const std::optional<PanTiltAngles>& requested() const {
        return m_requested;
    }  ///< angles that the unit shall reach; empty: none
    [[nodiscard]] bool turning() const { return m_rate != PanTiltAngles{}; }  ///< whether it turns at a rate

private:
    [[nodiscard]] PanTiltAngles base() const { return m_requested.value_or(m_now.value_or(PanTiltAngles{})); }
    void want(const PanTiltAngles& angles, SteadyTime now);
    void moveOn(SteadyTime now);

    PanTiltMount m_mount;
    std::optional<PanTiltAngles> m_now, m_requested, m_sent;
    PanTiltAngles m_rate;
    SteadyTime m_changed = {}, m_sentAt = {}, m_movedTo = {};
};

}  // namespace leitstand
