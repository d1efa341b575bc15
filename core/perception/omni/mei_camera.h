#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

namespace leitstand {

struct CameraInfoSample;

/// A camera below a mirror, in the unified model (Mei & Rives, "Single View Point Omnidirectional Camera
/// Calibration from Planar Grids", 2007, section II). A direction is projected onto the unit sphere, viewed
/// from a point xi above its middle, distorted (Brown) and scaled. Optical frame: x to the right of the
/// picture, y down, z along the axis. Pixels are those of CameraInfo: the middle of the first is (0, 0).
class MeiCamera {
public:
    /// Creates the camera for pictures of @p width x @p height, which may be smaller than those of its
    /// calibration. Empty unless @p info has the model "mei" with D = k1 k2 p1 p2 xi, with xi from 0 to 10,
    /// and focal lengths.
    [[nodiscard]] static std::optional<MeiCamera> of(const CameraInfoSample& info, int width, int height);

    /// Returns the pixel of @p direction (any length), which may be outside the picture. Empty for directions
    /// that the model does not cover.
    [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& direction) const;
    /// Returns the direction of @p pixel (unit length); empty outside the mirror.
    [[nodiscard]] std::optional<Eigen::Vector3d> direction(const Eigen::Vector2d& pixel) const;

private:
    MeiCamera() = default;
    [[nodiscard]] Eigen::Vector2d distorted(const Eigen::Vector2d& plane) const;

    Eigen::Vector2d m_focal, m_centre;        ///< [px]
    std::array<double, 4> m_distortion = {};  ///< k1 k2 p1 p2
    double m_xi = 0.0;
};

}  // namespace leitstand
