#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/perception/surroundings/virtual_scan_view.h"
#include "core/robot/control/drive_setpoint.h"

namespace leitstand {

/// The strip that a body covers when it goes on as it is commanded; base_link [m].
struct PredictedPath {
    std::vector<Eigen::Vector2d> left, right;  ///< edges, from the body on; empty when it stands

    [[nodiscard]] bool isEmpty() const { return left.empty(); }
};
/// The path of @p body over the next @p seconds at @p velocity, until it touches an obstacle of @p view (may
/// be null). Turning on the spot makes none.
[[nodiscard]] PredictedPath predictedPath(const BodyBox& body, const DriveVelocity& velocity, double seconds,
                                          const VirtualScanView* view = nullptr);

/// Whether @p point (base_link) stands before the outer contour of @p view: the inner contour has the walls
/// too, which are no obstacles of their own. Without an outer contour there everything does.
[[nodiscard]] bool standsBeforeWall(const VirtualScanView& view, const Eigen::Vector2d& point);

/// The horizon in the picture of a camera, in units of its focal length: y = offset + slope * x, from the
/// middle, x to the right, y down.
struct Horizon {
    double offset = 0.0, slope = 0.0;
    bool visible = true;  ///< false: the camera looks straight up or down
};
/// @p roll and @p pitch of the robot (REP 103: right side down, nose down), @p pan (left) and @p tilt (down)
/// of its camera [rad].
[[nodiscard]] Horizon horizonOf(double roll, double pitch, double pan, double tilt);

}  // namespace leitstand
