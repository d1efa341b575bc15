#include "robots/simulation/sensors/camera/camera_model.h"

#include <cmath>
#include <utility>

#include "core/base/pose.h"

namespace leitstand::simulation {
namespace {

constexpr int UndistortSteps = 20;

/// Returns @p plane, distorted (Brown).
Eigen::Vector2d distorted(const CameraModel& camera, const Eigen::Vector2d& plane) {
    const double x = plane.x(), y = plane.y(), r2 = plane.squaredNorm();
    const double radial = 1.0 + r2 * (camera.k1 + r2 * camera.k2);
    return {x * radial + 2.0 * camera.p1 * x * y + camera.p2 * (r2 + 2.0 * x * x),
            y * radial + camera.p1 * (r2 + 2.0 * y * y) + 2.0 * camera.p2 * x * y};
}

Eigen::Vector2d undistorted(const CameraModel& camera, const Eigen::Vector2d& seen) {
    Eigen::Vector2d plane = seen;
    for (int step = 0; step < UndistortSteps; ++step) plane += seen - distorted(camera, plane);
    return plane;
}

double angleOffAxis(const Eigen::Vector3d& direction) {
    return std::atan2(direction.head<2>().norm(), direction.z());
}

bool sees(const CameraModel& camera, double angle) {
    return angle >= camera.fromAngle && angle <= camera.toAngle;
}

}  // namespace

std::optional<Eigen::Vector2d> CameraModel::project(const Eigen::Vector3d& point) const {
    const double depth = point.z() + xi * point.norm();
    if (!(depth > 1e-9) || !sees(*this, angleOffAxis(point))) return std::nullopt;
    const Eigen::Vector2d seen = distorted(*this, point.head<2>() / depth);
    return Eigen::Vector2d(fx * seen.x() + cx, fy * seen.y() + cy);
}

std::optional<Eigen::Vector3d> CameraModel::direction(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d plane = undistorted(*this, {(pixel.x() - cx) / fx, (pixel.y() - cy) / fy});
    const double r2 = plane.squaredNorm(), root = 1.0 + (1.0 - xi * xi) * r2;
    if (!(root >= 0.0)) return std::nullopt;
    const double onSphere = (xi + std::sqrt(root)) / (1.0 + r2);
    const Eigen::Vector3d ray(onSphere * plane.x(), onSphere * plane.y(), onSphere - xi);
    if (!sees(*this, angleOffAxis(ray))) return std::nullopt;
    return ray.normalized();
}

CameraModel CameraModel::scaledTo(int maxWidth) const {
    if (maxWidth <= 0 || maxWidth >= width) return *this;
    CameraModel scaled = *this;
    scaled.width = maxWidth;
    scaled.height = std::max(1, static_cast<int>(std::lround(double(height) * maxWidth / width)));
    const double across = double(scaled.width) / width, down = double(scaled.height) / height;
    scaled.fx *= across;
    scaled.fy *= down;
    scaled.cx = (cx + 0.5) * across - 0.5;
    scaled.cy = (cy + 0.5) * down - 0.5;
    return scaled;
}

CameraInfoSample CameraModel::info(const SampleHeader& header) const {
    CameraInfoSample info;
    info.header = header;
    info.width = width;
    info.height = height;
    info.distortionModel = mirror ? "mei" : "plumb_bob";
    info.distortion = {k1, k2, p1, p2, mirror ? xi : 0.0};
    info.intrinsics = {fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0};
    info.rectification = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    info.projection = {fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0};
    return info;
}

CameraModel pinholeCamera() {
    CameraModel camera;
    camera.k1 = -0.12;
    camera.k2 = 0.02;
    camera.p1 = 0.0005;
    camera.p2 = -0.0003;
    camera.cx = 161.2;
    camera.cy = 118.1;
    return camera;
}

CameraModel infraredOptics() {
    CameraModel camera;
    camera.width = 160;
    camera.height = 120;
    camera.fx = camera.fy = 220.0;
    camera.cx = 79.5;
    camera.cy = 59.5;
    return camera;
}

CameraModel omnidirectionalCamera() {
    CameraModel camera;
    camera.width = camera.height = 320;
    camera.fx = camera.fy = 110.0;
    camera.cx = 160.3;
    camera.cy = 158.9;
    camera.k1 = -0.01;
    camera.xi = 0.95;
    camera.mirror = true;
    camera.fromAngle = degrees(12);
    camera.toAngle = degrees(105);
    return camera;
}

}  // namespace leitstand::simulation
