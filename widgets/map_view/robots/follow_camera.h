#pragma once

#include <optional>

#include "core/base/pose.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// A camera that follows a robot smoothly, with the robot's heading up. It does not move while the robot
/// stands, so that a full picture can be drawn.
class FollowCamera {
public:
    /// Starts following. @p parallel: the projection is that of the top look, which always looks from above.
    void start(MapFollow how, bool parallel);
    /// Whether the robot's pose is known.
    [[nodiscard]] bool aimed() const { return m_aimed; }
    /// Follows the robot to @p baseInMap, @p seconds after the last call. Jumps there the first time, and
    /// over long distances. Returns whether the camera moved.
    bool aim(const Pose& baseInMap, double seconds);
    [[nodiscard]] const MapCamera& camera() const { return m_camera; }

    /// Takes direction and distance from @p camera, after the operator moved the camera there.
    void adjust(const MapCamera& camera);

    static constexpr double Lag = 0.25;  ///< [s]

private:
    [[nodiscard]] MapCamera wanted() const;

    Pose m_robot = Pose::Identity();
    MapCamera m_camera;
    double m_yaw = 0.0;  ///< relative to the robot's heading [rad]
    double m_pitch = 0.0, m_distance = 5.0;
    bool m_parallel = false, m_aimed = false, m_moving = false;
};

}  // namespace leitstand
