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

/// Names of keys as they are written in the picture.
struct CameraKeyNames {
    QString turn, recentre;
};

/// Returns whether @p picture is known to come from an omnidirectional camera. @p picture may be null.
[[nodiscard]] bool isOmni(const ShownPicture* picture);

/// Returns what every picture shows about its camera: pan and tilt, and how the picture was processed.
/// @p turn: empty for a camera that cannot be turned. @p picture may be null. @p autoRange: whether infrared
/// colours follow the picture.
[[nodiscard]] CameraOverlay cameraOverlay(const std::optional<CameraTurn>& turn, const ShownPicture* picture,
                                          bool autoRange, const CameraKeyNames& keys = {});
/// Adds what the driver of @p robot must know. Omnidirectional pictures get no horizon.
void addDriving(CameraOverlay& overlay, const RobotDescription& robot, const LiveMoment& moment,
                const ShownPicture* picture);

/// Adds what the detectors of @p robot see in @p picture, unless that is a panorama. @p picture may be null.
void addDetections(CameraOverlay& overlay, const RobotDescription& robot, const LiveMoment& moment,
                   const ShownPicture* picture);

/// Returns the direction of @p place in @p picture, of unit length, in the camera's optical frame. @p place:
/// shares of width and height (0 to 1), from the top left. Assumes an angle of view of 60 degrees if the
/// calibration is missing or of an unknown kind.
[[nodiscard]] Eigen::Vector3d directionAt(const ShownPicture& picture, const QPointF& place);
/// Converts @p place in the shown @p picture, which may be a panorama, to a place in the picture as received.
/// Both are shares of width and height (0 to 1), from the top left. Empty: the camera of @p robot does not
/// see it, or its calibration is unknown.
[[nodiscard]] std::optional<Eigen::Vector2d> rawPlace(const RobotDescription& robot,
                                                      const ShownPicture& picture, const QPointF& place);
/// Returns where @p picture shows what is straight ahead of @p robot, as shares of width and height (0 to 1),
/// from the top left. Empty: the camera is not omnidirectional, or the picture was unwrapped.
[[nodiscard]] std::optional<QPointF> frontIn(const RobotDescription& robot, const ShownPicture& picture);

}  // namespace leitstand
