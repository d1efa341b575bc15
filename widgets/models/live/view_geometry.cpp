#include "widgets/models/live/view_geometry.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace leitstand {

PredictedPath predictedPath(const BodyBox& body, const DriveVelocity& velocity, double seconds,
                            const VirtualScanView* view) {
    constexpr int Steps = 24;
    PredictedPath path;
    const double speed = std::abs(velocity.forward) + std::abs(velocity.turn) * body.reach();
    if (std::abs(velocity.forward) < 1e-3 || !std::isfinite(speed)) return path;
    if (view != nullptr) {
        const double limit = speed * seconds;
        seconds = view->freeTravel(velocity.forward, velocity.turn, body, limit) / speed;
    }
    const double end = velocity.forward > 0.0 ? body.front : -body.back;
    for (int i = 0; i <= Steps; ++i) {
        const double time = seconds * i / Steps;
        const double yaw = velocity.turn * time;
        const Eigen::Vector2d moved =
            std::abs(velocity.turn) < 1e-6
                ? Eigen::Vector2d(velocity.forward * time, 0.0)
                : Eigen::Vector2d(std::sin(yaw), 1.0 - std::cos(yaw)) * (velocity.forward / velocity.turn);
        const Eigen::Rotation2Dd turned(yaw);
        path.left.push_back(moved + turned * Eigen::Vector2d(end, body.left));
        path.right.push_back(moved + turned * Eigen::Vector2d(end, -body.right));
    }
    return path;
}

bool standsBeforeWall(const VirtualScanView& view, const Eigen::Vector2d& point) {
    constexpr int Beside = 3;  // sectors: a wall at a grazing angle is spread over them
    const double near = 0.15 + 0.03 * point.norm();
    const int count = static_cast<int>(view.sectors.size());
    if (count == 0) return true;
    const int middle = view.sectorOf(std::atan2(point.y(), point.x()));
    const Eigen::Vector2d* before = nullptr;
    for (int i = middle - Beside; i <= middle + Beside; ++i) {
        const VirtualSector& sector = view.sectors[static_cast<std::size_t>((i % count + count) % count)];
        if (!sector.outer) continue;
        const Eigen::Vector2d& outer = *sector.outer;
        if ((outer - point).norm() < near) return false;
        if (before != nullptr && (outer - *before).norm() < 1.2) {
            const Eigen::Vector2d along = outer - *before;
            const double share = std::clamp((point - *before).dot(along) / along.squaredNorm(), 0.0, 1.0);
            if ((*before + share * along - point).norm() < near) return false;
        }
        before = &outer;
    }
    return true;
}

Horizon horizonOf(double roll, double pitch, double pan, double tilt) {
    using Eigen::AngleAxisd, Eigen::Vector3d;
    const Eigen::Matrix3d baseInLevel =
        (AngleAxisd(pitch, Vector3d::UnitY()) * AngleAxisd(roll, Vector3d::UnitX())).toRotationMatrix();
    const Eigen::Matrix3d cameraInBase =
        (AngleAxisd(pan, Vector3d::UnitZ()) * AngleAxisd(tilt, Vector3d::UnitY())).toRotationMatrix();
    // A pixel (x, y) looks along (1, -x, -y) of the camera; it is on the horizon where that is level.
    const Vector3d up = (baseInLevel * cameraInBase).transpose() * Vector3d::UnitZ();
    if (!(std::abs(up.z()) >= 0.05)) return {0.0, 0.0, false};
    return {up.x() / up.z(), -up.y() / up.z(), true};
}

}  // namespace leitstand
