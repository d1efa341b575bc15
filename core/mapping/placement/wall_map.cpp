#include "core/mapping/placement/wall_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace leitstand {
namespace {

constexpr double FloorWithin = 0.8, FloorAbout = 0.3;  ///< around the place, level and vertical [m]
constexpr float Level = 0.9F, Upright = 0.5F;          ///< of a normal's z: a floor has more, a wall less
constexpr std::size_t EnoughFloor = 10;

double groundAt(const PointCloud& cloud, const Eigen::Vector3d& place) {
    std::vector<float> heights;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3d off = cloud.points[i].cast<double>() - place;
        if (off.head<2>().norm() > FloorWithin || std::abs(off.z()) > FloorAbout) continue;
        if (std::abs(cloud.normals[i].z()) > Level) heights.push_back(cloud.points[i].z());
    }
    if (heights.size() < EnoughFloor) return place.z();
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    return double{*middle};
}

}  // namespace

WallMap wallMap(const LocalMap& local, const Pose& place, double low, double high) {
    WallMap map;
    map.ground = place.translation().z();
    if (local.cloud.normals.empty()) return map;
    map.ground = groundAt(local.cloud, place.translation());
    for (std::size_t i = 0; i < local.cloud.size(); ++i) {
        const Eigen::Vector3f& point = local.cloud.points[i];
        const Eigen::Vector3f& normal = local.cloud.normals[i];
        const double height = double{point.z()} - map.ground;
        if (height < low || height > high || std::abs(normal.z()) > Upright) continue;
        const float length = normal.head<2>().norm();
        if (length < Upright) continue;  // its direction is unknown
        map.walls.points.emplace_back(point.x(), point.y(), 0.0F);
        map.walls.normals.emplace_back(normal.x() / length, normal.y() / length, 0.0F);
    }
    if (!map.walls.points.empty()) map.search = makeSearch(map.walls, SearchMethod::KdTree);
    return map;
}

}  // namespace leitstand
