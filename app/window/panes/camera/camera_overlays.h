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

/// Names of keys, as written into the picture.
struct CameraKeyNames {
    QString turn, recentre;
};

/// Returns whether @p picture, which may be null, is of a camera that is known to see all around.
[[nodiscard]] bool isOmni(const ShownPicture* picture);

/// Returns what every picture shows of its camera: how it is turned, and what was done to the picture. @p
/// picture may be null.
[[nodiscard]] CameraOverlay cameraOverlay(const std::optional<CameraTurn>& turn, const ShownPicture* picture,
                                          bool autoRange, const CameraKeyNames& keys = {});
/// Adds what the driver of @p robot has to know. Omnidirectional pictures get no horizon.
void addDriving(CameraOverlay& overlay, const RobotDescription& robot, const LiveMoment& moment,
                const ShownPicture* picture);

/// Returns the direction, in the optical frame, of @p place in @p picture (0 to 1 of both sides). Assumes a
/// view of 60 degrees across when the camera is not calibrated.
[[nodiscard]] Eigen::Vector3d directionAt(const ShownPicture& picture, const QPointF& place);
/// Converts @p place in @p picture as it is shown, which may be a panorama, to a place in the picture as it
/// came. Both are 0 to 1 of both sides. Empty when @p robot's camera does not see it.
[[nodiscard]] std::optional<Eigen::Vector2d> rawPlace(const RobotDescription& robot,
                                                      const ShownPicture& picture, const QPointF& place);
/// Returns where the robot's front is in @p picture, 0 to 1 of both sides. Empty unless it is a picture of an
/// omnidirectional camera that was not unwrapped.
[[nodiscard]] std::optional<QPointF> frontIn(const RobotDescription& robot, const ShownPicture& picture);

}  // namespace leitstand
