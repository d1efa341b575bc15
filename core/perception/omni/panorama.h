#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/event/picture_samples.h"
#include "core/perception/omni/mei_camera.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Size of a panorama and the part of the surroundings that it shows. It shows all directions: ahead is in
/// the middle, left is on the left. Columns are equal steps of yaw, rows equal steps of elevation. The middle
/// of the first pixel is (0.5, 0.5).
struct PanoramaShape {
    int width = 0, height = 0;                            ///< [px]
    double lowest = degrees(-60), highest = degrees(15);  ///< elevations of the lower and upper edges [rad]

    [[nodiscard]] double yawAt(double x) const;          ///< yaw, positive to the left, from pi to -pi [rad]
    [[nodiscard]] double elevationAt(double y) const;    ///< [rad]
    [[nodiscard]] double columnOf(double yaw) const;     ///< @p yaw: any angle [rad]
    [[nodiscard]] double rowOf(double elevation) const;  ///< row of @p elevation; may be outside the picture
    friend bool operator==(const PanoramaShape&, const PanoramaShape&) = default;
};

/// Makes panoramas from the pictures of one omnidirectional camera. The table that maps pixels is computed
/// once.
class Panorama {
public:
    /// Creates a panorama for a camera whose pictures are @p width x @p height. @p cameraInBase: pose of its
    /// optical frame in base_link; only the attitude is used. @p range gives the lowest and highest
    /// elevation; its size is ignored. The panorama's size follows from the picture, so that no detail at the
    /// horizon is lost (240 to 2400 pixels wide). Empty without a calibration in Mei's model, and for a range
    /// of 5 degrees or less.
    [[nodiscard]] static std::optional<Panorama> of(const CameraInfoSample& info, int width, int height,
                                                    const Pose& cameraInBase,
                                                    const PanoramaShape& range = {});

    [[nodiscard]] const PanoramaShape& shape() const { return m_shape; }
    /// Whether this panorama was made for pictures with this calibration and size. The camera's pose is not
    /// compared.
    [[nodiscard]] bool fits(const CameraInfoSample& info, int width, int height) const;
    /// Returns @p picture unwrapped, black where the camera sees nothing. A picture of another size than that
    /// given to of() is returned unchanged.
    [[nodiscard]] Picture unwrapped(const Picture& picture) const;

private:
    Panorama() = default;

    PanoramaShape m_shape;
    int m_width = 0, m_height = 0;  ///< size of the pictures [px]
    CameraInfoSample m_info;
    std::vector<float> m_x, m_y;  ///< source of each pixel of the panorama, row by row
};

/// Returns where a direction is in a picture of @p width x @p height that was not unwrapped: as shares of
/// width and height. Values outside 0 to 1 are outside the picture. The direction is @p yaw to the left of
/// ahead, and @p elevation above the height of the camera [rad]. Empty where the camera cannot see it or is
/// not calibrated.
[[nodiscard]] std::optional<Eigen::Vector2d> rawPlaceOf(const CameraInfoSample& info,
                                                        const Pose& cameraInBase, double yaw, int width,
                                                        int height, double elevation = 0.0);

}  // namespace leitstand
