#include "core/perception/pictures/pixel_ray.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

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

/// Lens of a calibration.
enum class Lens : std::uint8_t { Usual, Fisheye, Unknown };

Lens lensOf(const CameraInfoSample& camera) {
    const std::string& model = camera.distortionModel;
    if (model.empty() || model == "plumb_bob" || model == "rational_polynomial") return Lens::Usual;
    return isFisheye(camera) ? Lens::Fisheye : Lens::Unknown;
}

/// Where a fisheye lens shows a direction that is @p angle off its axis, and how fast that grows with the
/// angle. Model: Kannala & Brandt 2006, as OpenCV and ROS have it.
std::pair<double, double> shownAt(double angle, const std::vector<double>& d) {
    const auto term = [&d](std::size_t i) { return i < d.size() ? d[i] : 0.0; };
    const double a2 = angle * angle;
    double shown = 1.0, slope = 1.0, power = 1.0;
    for (std::size_t i = 0; i < 4; ++i) {
        power *= a2;
        shown += term(i) * power;
        slope += static_cast<double>(2 * i + 3) * term(i) * power;
    }
    return {angle * shown, slope};
}

/// Inverse of shownAt(); empty where the lens shows nothing.
std::optional<double> angleShownAt(double distance, const std::vector<double>& d) {
    double angle = distance;
    for (int i = 0; i < 20; ++i) {
        const auto [shown, slope] = shownAt(angle, d);
        if (!(slope > 0.0)) return std::nullopt;
        angle -= (shown - distance) / slope;
    }
    const double rest = std::abs(shownAt(angle, d).first - distance);
    if (!(rest < 1e-6) || !(angle >= 0.0) || angle > std::numbers::pi) return std::nullopt;
    return angle;
}

/// Place on the plane z = 1 that a camera without distortion would show at @p pixel.
Eigen::Vector2d onPlane(const CameraInfoSample& camera, const Eigen::Vector2d& pixel, int width, int height) {
    const double scaleX = camera.width > 0 ? static_cast<double>(camera.width) / width : 1.0;
    const double scaleY = camera.height > 0 ? static_cast<double>(camera.height) / height : 1.0;
    // CameraInfo counts from the middle of the first pixel.
    return {(pixel.x() * scaleX - 0.5 - camera.intrinsics[2]) / camera.intrinsics[0],
            (pixel.y() * scaleY - 0.5 - camera.intrinsics[5]) / camera.intrinsics[4]};
}

/// Inverse of onPlane().
Eigen::Vector2d fromPlane(const CameraInfoSample& camera, const Eigen::Vector2d& place, int width,
                          int height) {
    const double scaleX = camera.width > 0 ? static_cast<double>(camera.width) / width : 1.0;
    const double scaleY = camera.height > 0 ? static_cast<double>(camera.height) / height : 1.0;
    return {(place.x() * camera.intrinsics[0] + camera.intrinsics[2] + 0.5) / scaleX,
            (place.y() * camera.intrinsics[4] + camera.intrinsics[5] + 0.5) / scaleY};
}

bool isCalibrated(const CameraInfoSample& camera, int width, int height) {
    return camera.intrinsics[0] > 0.0 && camera.intrinsics[4] > 0.0 && width > 0 && height > 0 &&
           lensOf(camera) != Lens::Unknown;
}

}  // namespace

bool isFisheye(const CameraInfoSample& camera) {
    return camera.distortionModel == "equidistant" || camera.distortionModel == "fisheye";
}

std::optional<Eigen::Vector3d> pixelDirection(const CameraInfoSample& camera, const Eigen::Vector2d& pixel,
                                              int width, int height) {
    if (!isCalibrated(camera, width, height) || !pixel.allFinite()) return std::nullopt;
    const Eigen::Vector2d seen = onPlane(camera, pixel, width, height);
    if (lensOf(camera) == Lens::Fisheye) {
        const double distance = seen.norm();
        const auto angle = angleShownAt(distance, camera.distortion);
        if (!angle) return std::nullopt;
        const double aside = distance > 0.0 ? std::sin(*angle) / distance : 0.0;
        return Eigen::Vector3d(aside * seen.x(), aside * seen.y(), std::cos(*angle));
    }
    Eigen::Vector2d point = seen;
    for (int i = 0; i < 20 && !camera.distortion.empty(); ++i) {
        point += seen - distorted(point, camera.distortion);
    }
    if (!point.allFinite()) return std::nullopt;
    return Eigen::Vector3d(point.x(), point.y(), 1.0).normalized();
}

std::optional<Eigen::Vector2d> pixelOf(const CameraInfoSample& camera, const Eigen::Vector3d& direction,
                                       int width, int height) {
    if (!isCalibrated(camera, width, height)) return std::nullopt;
    Eigen::Vector2d seen;
    if (lensOf(camera) == Lens::Fisheye) {
        const double aside = direction.head<2>().norm();
        const auto [shown, slope] = shownAt(std::atan2(aside, direction.z()), camera.distortion);
        if (!(slope > 0.0)) return std::nullopt;
        seen = aside > 0.0 ? Eigen::Vector2d(direction.head<2>() * (shown / aside)) : Eigen::Vector2d::Zero();
    } else {
        if (!(direction.z() > 0.0)) return std::nullopt;
        seen = distorted(direction.head<2>() / direction.z(), camera.distortion);
    }
    const Eigen::Vector2d pixel = fromPlane(camera, seen, width, height);
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
