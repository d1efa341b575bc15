#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// The strip that a body covers when it continues as commanded; base_link [m].
struct PredictedPath {
    std::vector<Eigen::Vector2d> left, right;  ///< edges, from the body on; empty when it stands

    [[nodiscard]] bool isEmpty() const { return left.empty(); }
};
/// Returns the path of @p body over the next @p seconds at @p velocity, until it touches an obstacle of
/// @p view (may be null). Empty when the body stands or turns on the spot.
[[nodiscard]] PredictedPath predictedPath(const BodyBox& body, const DriveVelocity& velocity, double seconds,
                                          const VirtualScanView* view = nullptr);

/// Whether @p point (base_link) stands before the outer contour of @p view. The inner contour also holds the
/// walls, which are no obstacles of their own. True where there is no outer contour.
[[nodiscard]] bool standsBeforeWall(const VirtualScanView& view, const Eigen::Vector2d& point);

/// The horizon in the picture of a camera, in units of its focal length: y = offset + slope * x, from the
/// middle, x to the right, y down.
struct Horizon {
    double offset = 0.0, slope = 0.0;
    bool visible = true;  ///< false: the camera looks straight up or down
};
/// Returns the horizon for a robot with @p roll and @p pitch (REP 103: right side down, nose down). Its
/// camera has @p pan (left) and @p tilt (down). All angles in [rad].
[[nodiscard]] Horizon horizonOf(double roll, double pitch, double pan, double tilt);

}  // namespace leitstand
