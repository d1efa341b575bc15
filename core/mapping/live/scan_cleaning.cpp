#include "core/mapping/live/scan_cleaning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>


namespace leitstand {
namespace {

const Eigen::Vector3f NoEcho = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());

/// Whether @p point is within the polygon @p corners (crossings of a ray along x).
bool within(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& point) {
    bool inside = false;
    for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
        const Eigen::Vector2d &a = corners[i], &b = corners[before];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
}

double squaredDistance(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& point) {
    const Eigen::Vector2d side = b - a;
    const double length = side.squaredNorm();
    const double share = length > 0.0 ? std::clamp((point - a).dot(side) / length, 0.0, 1.0) : 0.0;
    return (a + share * side - point).squaredNorm();
}

bool nearTo(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& point, double margin) {
    for (std::size_t i = 0, before = corners.size() - 1; i < corners.size(); before = i++) {
        if (squaredDistance(corners[before], corners[i], point) < margin * margin) return true;
    }
    return false;
}

}  // namespace

bool MapCrop::contains(const Eigen::Vector3d& pointInMap) const {
    if (!(pointInMap.z() <= ceiling)) return false;
    return polygon.empty() || within(polygon, pointInMap.head<2>());
}

bool onFootprint(const RobotBody& body, const Eigen::Vector2d& place, double margin) {
    if (body.footprint.empty()) return false;
    return within(body.footprint, place) || nearTo(body.footprint, place, margin);
}

void leaveOutBody(Scan& scan, const RobotBody& body, const Pose& sensorInBase, double margin) {
    if (body.footprint.empty()) return;
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : body.footprint) box.extend(corner);
    box.extend(box.min() - Eigen::Vector2d::Constant(margin));
    box.extend(box.max() + Eigen::Vector2d::Constant(margin));
    for (Eigen::Vector3f& point : scan.points) {
        if (!point.allFinite()) continue;
        const Eigen::Vector3d inBase = sensorInBase * point.cast<double>();
        // The ground below belongs to the world, the robot begins above it.
        if (inBase.z() < margin || inBase.z() > body.height + margin) continue;
        const Eigen::Vector2d place = inBase.head<2>();
        if (!box.contains(place)) continue;
        if (onFootprint(body, place, margin)) point = NoEcho;
    }
}

void leaveOutCropped(Scan& scan, const MapCrop& crop, const Pose& scanInMap) {
    if (crop.open()) return;
    for (Eigen::Vector3f& point : scan.points) {
        if (point.allFinite() && !crop.contains(scanInMap * point.cast<double>())) point = NoEcho;
    }
}

}  // namespace leitstand
