#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/perception/omni/mei_camera.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Which part of the surroundings a panorama shows: all around, ahead in the middle, left of it what is left.
/// Columns are equal steps of yaw, rows of elevation. Pixels: the middle of the first is (0.5, 0.5).
struct PanoramaShape {
    int width = 0, height = 0;                            ///< [px]
    double lowest = degrees(-60), highest = degrees(15);  ///< elevations of the lower and upper border [rad]

    [[nodiscard]] double yawAt(double x) const;          ///< to the left of ahead, pi to -pi [rad]
    [[nodiscard]] double elevationAt(double y) const;    ///< [rad]
    [[nodiscard]] double columnOf(double yaw) const;     ///< @p yaw: any angle [rad]
    [[nodiscard]] double rowOf(double elevation) const;  ///< may be off the picture
    friend bool operator==(const PanoramaShape&, const PanoramaShape&) = default;
};

/// Makes panoramas of the pictures of one omnidirectional camera; its table is made once.
class Panorama {
public:
    /// Of a camera at @p cameraInBase (optical frame in base_link; only its attitude counts), whose pictures
    /// are @p width x @p height. Elevations as @p range has them; its size is set from the picture, so that
    /// nothing that the horizon shows is lost. Empty when there is no calibration by Mei's model.
    [[nodiscard]] static std::optional<Panorama> of(const CameraInfoSample& info, int width, int height,
                                                    const Pose& cameraInBase,
                                                    const PanoramaShape& range = {});

    [[nodiscard]] const PanoramaShape& shape() const { return m_shape; }
    /// Whether this one was made for such pictures.
    [[nodiscard]] bool fits(const CameraInfoSample& info, int width, int height) const;
    /// @p picture unwrapped, black where the camera sees nothing. As it is when its size is another.
    [[nodiscard]] Picture unwrapped(const Picture& picture) const;

private:
    Panorama() = default;

    PanoramaShape m_shape;
    int m_width = 0, m_height = 0;  ///< of the pictures [px]
    CameraInfoSample m_info;
    std::vector<float> m_x, m_y;  ///< where each pixel of the panorama comes from, row by row
};

/// Where @p yaw (to the left of ahead) at @p elevation above the height of the camera [rad] is in a picture
/// of
/// @p width x @p height that was not unwrapped, 0 to 1 of both; empty where the camera does not see it or is
/// not calibrated.
[[nodiscard]] std::optional<Eigen::Vector2d> rawPlaceOf(const CameraInfoSample& info,
                                                        const Pose& cameraInBase, double yaw, int width,
                                                        int height, double elevation = 0.0);

}  // namespace leitstand
