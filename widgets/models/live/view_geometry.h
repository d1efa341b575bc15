#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// The area over which a body moves if it continues as commanded; base_link [m].
struct PredictedPath {
    /// Left and right edges, beginning at the body; empty if it stands.
    std::vector<Eigen::Vector2d> left, right;

    [[nodiscard]] bool isEmpty() const { return left.empty(); }
};
/// Returns the path of @p body over the next @p seconds at @p velocity, until it touches an obstacle of
/// @p view (which may be null). Empty when the body stands or turns on the spot.
[[nodiscard]] PredictedPath predictedPath(const BodyBox& body, const DriveVelocity& velocity, double seconds,
                                          const VirtualScanView* view = nullptr);

/// Whether @p point (base_link) is nearer than the outer contour of @p view. The inner contour also contains
/// the walls, which are not obstacles in addition. True where there is no outer contour.
[[nodiscard]] bool standsBeforeWall(const VirtualScanView& view, const Eigen::Vector2d& point);

/// The horizon in a camera's picture, in units of its focal length: y = offset + slope * x, measured from the
/// middle, x to the right, y down.
struct Horizon {
    double offset = 0.0, slope = 0.0;
    bool visible = true;  ///< false: the camera looks straight up or down
};
/// Returns the horizon for a robot with @p roll and @p pitch (REP 103; positive: right side or nose down).
/// Its camera has @p pan (to the left) and @p tilt (down). All angles in [rad].
[[nodiscard]] Horizon horizonOf(double roll, double pitch, double pan, double tilt);

}  // namespace leitstand
