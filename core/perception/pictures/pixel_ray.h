#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"

namespace leitstand {

struct CameraInfoSample;

/// A half-line.
struct Ray {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();      ///< [m]
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< of unit length
};

/// Returns the direction of @p pixel in the camera's optical frame (x right, y down, z forward), of unit
/// length. The picture has @p width x @p height and may be a reduced one of the calibration. Distortion is
/// "plumb_bob", "rational_polynomial" (5 or 8 parameters) or none; empty for others and when uncalibrated.
[[nodiscard]] std::optional<Eigen::Vector3d> pixelDirection(const CameraInfoSample& camera,
                                                            const Eigen::Vector2d& pixel, int width,
                                                            int height);

/// The inverse: returns the pixel of @p direction (optical frame), which may be off the picture. Empty behind
/// the camera, and as above.
[[nodiscard]] std::optional<Eigen::Vector2d> pixelOf(const CameraInfoSample& camera,
                                                     const Eigen::Vector3d& direction, int width, int height);

/// Returns @p direction of a camera's optical frame at @p opticalInBase as a ray in base_link.
[[nodiscard]] Ray rayFrom(const Pose& opticalInBase, const Eigen::Vector3d& direction);

/// Returns the optical frame (z forward) of a camera whose frame has x forward (REP 103).
[[nodiscard]] Pose opticalFrame(const Pose& cameraInBase);

}  // namespace leitstand
