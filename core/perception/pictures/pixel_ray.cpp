#include "core/perception/pictures/pixel_ray.h"

#include <cmath>

#include "core/event/picture_samples.h"

namespace leitstand {
namespace {

/// Distorts @p point of the plane z = 1 by a plumb_bob or rational lens.
Eigen::Vector2d distorted(const Eigen::Vector2d& point, const std::vector<double>& d) {
    const auto term = [&d](std::size_t i) { return i < d.size() ? d[i] : 0.0; };
    const double x = point.x(), y = point.y();
    const double r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
    const double radial = (1.0 + term(0) * r2 + term(1) * r4 + term(4) * r6) /
                          (1.0 + term(5) * r2 + term(6) * r4 + term(7) * r6);
    return {x * radial + 2.0 * term(2) * x * y + term(3) * (r2 + 2.0 * x * x),
            y * radial + term(2) * (r2 + 2.0 * y * y) + 2.0 * term(3) * x * y};
}

}  // namespace

std::optional<Eigen::Vector3d> pixelDirection(const CameraInfoSample& camera, const Eigen::Vector2d& pixel,
                                              int width, int height) {
    const double fx = camera.intrinsics[0], fy = camera.intrinsics[4];
    if (!(fx > 0.0) || !(fy > 0.0) || width <= 0 || height <= 0 || !pixel.allFinite()) return std::nullopt;
    const std::string& model = camera.distortionModel;
    if (!model.empty() && model != "plumb_bob" && model != "rational_polynomial") return std::nullopt;
    const double scaleX = camera.width > 0 ? static_cast<double>(camera.width) / width : 1.0;
    const double scaleY = camera.height > 0 ? static_cast<double>(camera.height) / height : 1.0;
    // CameraInfo counts from the middle of the first pixel.
    const Eigen::Vector2d seen((pixel.x() * scaleX - 0.5 - camera.intrinsics[2]) / fx,
                               (pixel.y() * scaleY - 0.5 - camera.intrinsics[5]) / fy);
    Eigen::Vector2d point = seen;
    for (int i = 0; i < 20 && !camera.distortion.empty(); ++i) {
        point += seen - distorted(point, camera.distortion);
    }
    if (!point.allFinite()) return std::nullopt;
    return Eigen::Vector3d(point.x(), point.y(), 1.0).normalized();
}

std::optional<Eigen::Vector2d> pixelOf(const CameraInfoSample& camera, const Eigen::Vector3d& direction,
                                       int width, int height) {
    const double fx = camera.intrinsics[0], fy = camera.intrinsics[4];
    if (!(fx > 0.0) || !(fy > 0.0) || width <= 0 || height <= 0 || !(direction.z() > 0.0))
        return std::nullopt;
    const std::string& model = camera.distortionModel;
    if (!model.empty() && model != "plumb_bob" && model != "rational_polynomial") return std::nullopt;
    const double scaleX = camera.width > 0 ? static_cast<double>(camera.width) / width : 1.0;
    const double scaleY = camera.height > 0 ? static_cast<double>(camera.height) / height : 1.0;
    const Eigen::Vector2d seen = distorted(direction.head<2>() / direction.z(), camera.distortion);
    const Eigen::Vector2d pixel((seen.x() * fx + camera.intrinsics[2] + 0.5) / scaleX,
                                (seen.y() * fy + camera.intrinsics[5] + 0.5) / scaleY);
    if (!pixel.allFinite()) return std::nullopt;
    return pixel;
}

Ray rayFrom(const Pose& opticalInBase, const Eigen::Vector3d& direction) {
    return {opticalInBase.translation(), (opticalInBase.linear() * direction).normalized()};
}

Pose opticalFrame(const Pose& cameraInBase) {
    Eigen::Matrix3d opticalInCamera;
    opticalInCamera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    Pose optical = cameraInBase;
    optical.linear() = cameraInBase.linear() * opticalInCamera;
    return optical;
}

}  // namespace leitstand
