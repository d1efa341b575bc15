#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

struct CameraInfoSample;

/// A half-line.
struct Ray {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();      ///< where it begins [m]
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< of unit length
};

/// Whether @p camera has a fisheye lens: its distortion is "equidistant" (also called "fisheye").
[[nodiscard]] bool isFisheye(const CameraInfoSample& camera);

/// Returns the direction of @p pixel in the camera's optical frame (x right, y down, z forward), of unit
/// length. The middle of the first pixel is (0.5, 0.5). The picture has @p width x @p height pixels, which
/// may be fewer than those of the calibration. Distortion is "plumb_bob", "rational_polynomial" (5 or 8
/// parameters), "equidistant" (4; also called "fisheye") or none. Empty for other distortions, without
/// calibration, and where a fisheye lens shows nothing.
[[nodiscard]] std::optional<Eigen::Vector3d> pixelDirection(const CameraInfoSample& camera,
                                                            const Eigen::Vector2d& pixel, int width,
                                                            int height);

/// Inverse of pixelDirection(): returns the pixel of @p direction (optical frame), which may be outside the
/// picture. Empty behind the camera, unless its lens is a fisheye, and where pixelDirection() is empty.
[[nodiscard]] std::optional<Eigen::Vector2d> pixelOf(const CameraInfoSample& camera,
                                                     const Eigen::Vector3d& direction, int width, int height);

/// Returns the ray in base_link that begins at a camera and has the direction @p direction. @p direction is
/// in the camera's optical frame, whose pose is @p opticalInBase.
[[nodiscard]] Ray rayFrom(const Pose& opticalInBase, const Eigen::Vector3d& direction);

/// Returns the pose of the optical frame (z forward) in base_link, for a camera frame with x forward (REP
/// 103).
[[nodiscard]] Pose opticalFrame(const Pose& cameraInBase);

}  // namespace leitstand
