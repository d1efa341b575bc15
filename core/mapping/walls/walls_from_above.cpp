#include "core/mapping/walls/walls_from_above.h"

#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace leitstand {
namespace {

constexpr float Upright = 0.5F;   ///< of a normal's z; a wall has less
constexpr double Thinned = 0.15;  ///< edge of a cell [m]

}  // namespace

std::vector<Eigen::Vector2f> wallsFromAbove(const PointCloud& cloud, const Eigen::Matrix3f& level,
                                            const WallBand& band) {
    std::vector<Eigen::Vector2f> walls;
    if (cloud.normals.size() != cloud.points.size()) return walls;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3f point = level * cloud.points[i];
        const float upwards = level.row(2).dot(cloud.normals[i]);
        if (point.z() < static_cast<float>(band.low) || point.z() > static_cast<float>(band.high)) continue;
        if (std::abs(upwards) > Upright || point.head<2>().norm() > static_cast<float>(band.reach)) continue;
        walls.emplace_back(point.head<2>());
    }
    return walls;
}

std::vector<Eigen::Vector2f> thinnedWalls(const std::vector<Eigen::Vector2f>& walls) {
    std::set<std::pair<int, int>> cells;
    std::vector<Eigen::Vector2f> kept;
    for (const Eigen::Vector2f& wall : walls) {
        const auto x = static_cast<int>(std::floor(wall.x() / Thinned)),
                   y = static_cast<int>(std::floor(wall.y() / Thinned));
        if (cells.emplace(x, y).second) kept.push_back(wall);
    }
    return kept;
}

}  // namespace leitstand
