#pragma once

#include <optional>

#include <Eigen/Core>
#include <QString>

#include "app/services/station/cameras/camera_turning.h"
#include "app/services/station/cameras/picture_feed.h"
#include "app/window/source/live_moment.h"
#include "core/robot/robot_description.h"
#include "widgets/camera/camera_pane.h"

namespace leitstand {

/// Keys as they are written into the picture.
struct CameraKeyNames {
    QString turn, recentre;
};

/// Whether @p picture, which may be null, is of a camera that is known to see all around.
[[nodiscard]] bool isOmni(const ShownPicture* picture);

/// What every camera's picture tells about itself: how it is turned, what was done to it. @p picture may be
/// null.
[[nodiscard]] CameraOverlay cameraOverlay(const std::optional<CameraTurn>& turn, const ShownPicture* picture,
                                          bool autoRange, const CameraKeyNames& keys = {});
/// Adds what the driver of @p robot has to know; a horizon only where the camera looks along it.
void addDriving(CameraOverlay& overlay, const RobotDescription& robot, const LiveMoment& moment,
                const ShownPicture* picture);

/// Where the camera of @p picture looks at @p place (0 to 1 of both sides) in its optical frame; by 60
/// degrees across where it is not calibrated.
[[nodiscard]] Eigen::Vector3d directionAt(const ShownPicture& picture, const QPointF& place);
/// Where @p place of @p picture as it is shown is in the picture as it came, which a panorama is not; 0 to 1
/// of both sides. Empty: what @p robot's camera does not see.
[[nodiscard]] std::optional<Eigen::Vector2d> rawPlace(const RobotDescription& robot,
                                                      const ShownPicture& picture, const QPointF& place);
/// Where the robot's front is in @p picture of an omnidirectional camera that was not unwrapped.
[[nodiscard]] std::optional<QPointF> frontIn(const RobotDescription& robot, const ShownPicture& picture);

}  // namespace leitstand
