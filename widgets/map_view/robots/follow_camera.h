#pragma once

#include <optional>

#include "core/base/pose.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// A camera that goes with a robot, its heading up, smoothly. It stands still while the robot stands: a full
/// picture can be drawn then.
class FollowCamera {
public:
    /// Begins anew: @p parallel as in the top look, which always sees from above.
    void start(MapFollow how, bool parallel);
    /// Whether it knows where the robot is.
    [[nodiscard]] bool aimed() const { return m_aimed; }
    /// The robot is at @p baseInMap now, @p seconds after the last call; jumps there at first and when it is
    /// far away. Returns whether the camera moved.
    bool aim(const Pose& baseInMap, double seconds);
    [[nodiscard]] const MapCamera& camera() const { return m_camera; }

    /// The operator turned it or changed its distance, to @p camera: it keeps that.
    void adjust(const MapCamera& camera);

    static constexpr double Lag = 0.25;  ///< [s]

private:
    [[nodiscard]] MapCamera wanted() const;

    Pose m_robot = Pose::Identity();
    MapCamera m_camera;
    double m_yaw = 0.0;  ///< against the robot's heading [rad]
    double m_pitch = 0.0, m_distance = 5.0;
    bool m_parallel = false, m_aimed = false, m_moving = false;
};

}  // namespace leitstand
