#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/event/picture_samples.h"

namespace leitstand {

/// A half-line.
struct Ray {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();      ///< [m]
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< of unit length
};

/// Where a camera looks through @p pixel of a picture of @p width x @p height (which may be a reduced one of
/// that it was calibrated with), in its optical frame (x right, y down, z forward), of unit length.
/// Distortion "plumb_bob", "rational_polynomial" (5 or 8 parameters) or none; empty for others and when
/// uncalibrated.
[[nodiscard]] std::optional<Eigen::Vector3d> pixelDirection(const CameraInfoSample& camera,
                                                            const Eigen::Vector2d& pixel, int width,
                                                            int height);

/// The other way round: where @p direction (optical frame) is seen; may lie outside the picture. Empty behind
/// the camera, and as above.
[[nodiscard]] std::optional<Eigen::Vector2d> pixelOf(const CameraInfoSample& camera,
                                                     const Eigen::Vector3d& direction, int width, int height);

/// @p direction of a camera's optical frame at @p opticalInBase as a ray in base_link.
[[nodiscard]] Ray rayFrom(const Pose& opticalInBase, const Eigen::Vector3d& direction);

/// The optical frame (z forward) of a camera whose frame has x forward (REP 103).
[[nodiscard]] Pose opticalFrame(const Pose& cameraInBase);

}  // namespace leitstand
