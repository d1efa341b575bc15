#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/event/picture_samples.h"
#include "core/perception/omni/mei_camera.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Part of the surroundings that a panorama shows: all around, ahead in the middle, the left on its left.
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

/// Makes panoramas of the pictures of one omnidirectional camera; its table is computed once.
class Panorama {
public:
    /// Creates a panorama for a camera at @p cameraInBase (optical frame in base_link; only its attitude
    /// counts), whose pictures are @p width x @p height. Elevations are those of @p range. Its size is set
    /// from the picture, so that no detail at the horizon is lost. Empty without a calibration by Mei's
    /// model.
    [[nodiscard]] static std::optional<Panorama> of(const CameraInfoSample& info, int width, int height,
                                                    const Pose& cameraInBase,
                                                    const PanoramaShape& range = {});

    [[nodiscard]] const PanoramaShape& shape() const { return m_shape; }
    /// Whether this one was made for such pictures.
    [[nodiscard]] bool fits(const CameraInfoSample& info, int width, int height) const;
    /// Returns @p picture unwrapped, black where the camera sees nothing; unchanged if its size is another.
    [[nodiscard]] Picture unwrapped(const Picture& picture) const;

private:
    Panorama() = default;

    PanoramaShape m_shape;
    int m_width = 0, m_height = 0;  ///< of the pictures [px]
    CameraInfoSample m_info;
    std::vector<float> m_x, m_y;  ///< source of each pixel of the panorama, row by row
};

/// Returns the place of a direction in a picture of @p width x @p height that was not unwrapped, 0 to 1 of
/// both. The direction is @p yaw (to the left of ahead) at @p elevation above the height of the camera [rad].
/// Empty where the camera does not see it or is not calibrated.
[[nodiscard]] std::optional<Eigen::Vector2d> rawPlaceOf(const CameraInfoSample& info,
                                                        const Pose& cameraInBase, double yaw, int width,
                                                        int height, double elevation = 0.0);

}  // namespace leitstand
