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

/// Returns the angles that keep what was grabbed under the pointer, as in a dragged picture. @p start: the
/// angles when it was grabbed. @p grabbed and @p pointer: directions in the camera's optical frame (x right,
/// y down, z ahead) at that time and now.
[[nodiscard]] PanTiltAngles dragged(const PanTiltAngles& start, const Eigen::Vector3d& grabbed,
                                    const Eigen::Vector3d& pointer);

/// Control of one pan-tilt unit by the operator: its angles, the requested angles, and what must be sent.
/// Pure: no clock, no thread.
class PanTiltControl {
public:
    explicit PanTiltControl(const PanTiltMount& mount) : m_mount(mount) {}

    void reported(const PanTiltAngles& now) { m_now = now; }  ///< as reported by the robot's joint states
    void turnTo(const PanTiltAngles& angles, SteadyTime now);
    /// Turns by @p step from the requested angles, or else from the reported ones.
    void turnBy(const PanTiltAngles& step, SteadyTime now);
    /// Turns at @p perSecond [rad/s] until the rate is set again; zero: stays at the angles requested so far.
    void setRate(const PanTiltAngles& perSecond, SteadyTime now);
    /// Returns what to send now, at most 25 times a second. The requested angles are repeated until the unit
    /// is there. They are dropped after 5 s without a change: something blocks the unit.
    [[nodiscard]] std::optional<PanTiltAngles> due(SteadyTime now);

    [[nodiscard]] const PanTiltMount& mount() const { return m_mount; }
    [[nodiscard]] const std::optional<PanTiltAngles>& now() const { return m_now; }  ///< empty: unknown
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
