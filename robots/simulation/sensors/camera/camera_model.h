#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/event/picture_samples.h"

namespace leitstand::simulation {

/// How a camera maps directions to pixels: the unified model of Mei & Rives (2007), where xi = 0 is a
/// pinhole. Optical frame: x to the right of the picture, y down, z along the axis; the middle of the first
/// pixel is (0, 0).
struct CameraModel {
    int width = 320, height = 240;          ///< [px]
    double fx = 277.0, fy = 277.0;          ///< [px]
    double cx = 159.5, cy = 119.5;          ///< [px]
    double k1 = 0.0, k2 = 0.0;              ///< radial distortion
    double p1 = 0.0, p2 = 0.0;              ///< tangential distortion
    double xi = 0.0;                        ///< parameter of the mirror; 0: no mirror
    bool mirror = false;                    ///< whether it reports "mei" instead of "plumb_bob"
    double fromAngle = 0.0, toAngle = 3.2;  ///< limits of its view, as angles from the axis [rad]

    /// Returns the pixel of a point or direction in the camera's frame; empty when the camera cannot see it.
    /// The pixel may be outside the picture.
    [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point) const;
    /// Returns the direction of a pixel in the camera's frame, unit length; empty where the camera sees
    /// nothing.
    [[nodiscard]] std::optional<Eigen::Vector3d> direction(const Eigen::Vector2d& pixel) const;
    /// Returns the same camera with pictures that are at most @p maxWidth wide [px]; 0: not changed.
    [[nodiscard]] CameraModel scaledTo(int maxWidth) const;
    [[nodiscard]] CameraInfoSample info(const SampleHeader& header) const;
};

/// Left and right camera of Kurt3D: 320 x 240, 60 degrees across.
[[nodiscard]] CameraModel pinholeCamera();
/// Infrared camera of Kurt3D: 160 x 120, 40 degrees across.
[[nodiscard]] CameraModel infraredOptics();
/// Camera below a mirror on the Crawler; its z axis points down. It sees in all directions, from 12 degrees
/// off its axis (closer to it, it would see itself) to 15 degrees above the horizon.
[[nodiscard]] CameraModel omnidirectionalCamera();

}  // namespace leitstand::simulation
