#include "core/perception/omni/mei_camera.h"

#include <algorithm>
#include <cmath>

#include "core/event/picture_samples.h"

namespace leitstand {
namespace {

constexpr int UndistortSteps = 20;
constexpr double LargestXi = 10.0;  ///< of mirrors and fisheyes: parabolic is 1

}  // namespace

std::optional<MeiCamera> MeiCamera::of(const CameraInfoSample& info, int width, int height) {
    const auto finite = [](double value) { return std::isfinite(value); };
    const bool reported = info.distortionModel == "mei" && info.distortion.size() == 5 &&
                          std::all_of(info.distortion.begin(), info.distortion.end(), finite) &&
                          std::all_of(info.intrinsics.begin(), info.intrinsics.end(), finite) &&
                          info.intrinsics[0] > 0.0 && info.intrinsics[4] > 0.0 && info.distortion[4] >= 0.0 &&
                          info.distortion[4] <= LargestXi;
    if (!reported || width <= 0 || height <= 0) return std::nullopt;
    const Eigen::Array2d scale(info.width > 0 ? static_cast<double>(width) / info.width : 1.0,
                               info.height > 0 ? static_cast<double>(height) / info.height : 1.0);
    MeiCamera camera;
    camera.m_focal = Eigen::Array2d(info.intrinsics[0], info.intrinsics[4]) * scale;
    camera.m_centre = (Eigen::Array2d(info.intrinsics[2], info.intrinsics[5]) + 0.5) * scale - 0.5;
    std::copy_n(info.distortion.begin(), 4, camera.m_distortion.begin());
    camera.m_xi = info.distortion[4];
    return camera;
}

Eigen::Vector2d MeiCamera::distorted(const Eigen::Vector2d& plane) const {
    const auto [k1, k2, p1, p2] = m_distortion;
    const double x = plane.x(), y = plane.y(), r2 = plane.squaredNorm();
    const double radial = 1.0 + r2 * (k1 + r2 * k2);
    return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
            y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

std::optional<Eigen::Vector2d> MeiCamera::project(const Eigen::Vector3d& direction) const {
    const double length = direction.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    const Eigen::Vector3d onSphere = direction / length;
    // Farther from the axis, two directions would share a pixel.
    if (!(onSphere.z() > -std::min(m_xi, 1.0 / std::max(m_xi, 1e-9)) + 1e-6)) return std::nullopt;
    const Eigen::Vector2d plane = onSphere.head<2>() / (onSphere.z() + m_xi);
    const Eigen::Vector2d seen = distorted(plane);
    return Eigen::Vector2d(m_focal.cwiseProduct(seen) + m_centre);
}

std::optional<Eigen::Vector3d> MeiCamera::direction(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d seen = (pixel - m_centre).cwiseQuotient(m_focal);
    Eigen::Vector2d plane = seen;
    for (int i = 0; i < UndistortSteps; ++i) plane += seen - distorted(plane);
    // equation 6 of the paper, back onto the sphere
    const double r2 = plane.squaredNorm(), root = 1.0 + (1.0 - m_xi * m_xi) * r2;
    if (!plane.allFinite() || !(root >= 0.0)) return std::nullopt;
    const double share = (m_xi + std::sqrt(root)) / (1.0 + r2);
    return Eigen::Vector3d(share * plane.x(), share * plane.y(), share - m_xi).normalized();
}

}  // namespace leitstand
