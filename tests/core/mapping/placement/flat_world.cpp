#include "tests/core/mapping/placement/flat_world.h"

#include <cmath>
#include <limits>
#include <random>

namespace leitstand::test {
namespace {

constexpr double Floor = -0.5, Step = 0.05;
constexpr int Rays = 681;

float asFloat(double value) {
    return static_cast<float>(value);
}

/// How far a ray goes to @p wall; infinite when it misses.
double distance(const FlatWorld::Wall& wall, const Eigen::Vector2d& from, const Eigen::Vector2d& along) {
    const Eigen::Vector2d side = wall.to - wall.from, off = wall.from - from;
    const double cross = along.x() * side.y() - along.y() * side.x();
    if (std::abs(cross) < 1e-9) return std::numeric_limits<double>::infinity();
    const double range = (off.x() * side.y() - off.y() * side.x()) / cross,
                 share = (off.x() * along.y() - off.y() * along.x()) / cross;
    return range > 0.0 && share >= 0.0 && share <= 1.0 ? range : std::numeric_limits<double>::infinity();
}

}  // namespace

FlatWorld FlatWorld::nook() {
    const std::vector<Eigen::Vector2d> corners = {{-1, -1.2}, {2, -1.2},  {2, 0.4},
                                                  {1.2, 0.4}, {1.2, 1.2}, {-1, 1.2}};
    std::vector<Wall> walls;
    for (std::size_t i = 0; i < corners.size(); ++i)
        walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return FlatWorld(walls);
}

FlatWorld FlatWorld::corridor() {
    return FlatWorld({{{-9, -1}, {9, -1}}, {{-9, 1}, {9, 1}}});
}

LocalMap FlatWorld::map() const {
    LocalMap map;
    for (const Wall& wall : m_walls) {
        const Eigen::Vector2d side = wall.to - wall.from, along = side.normalized();
        for (double way = 0.0; way < side.norm(); way += Step) {
            for (double height = 0.0; height < 1.0; height += Step) {
                const Eigen::Vector2d point = wall.from + way * along;
                map.cloud.points.emplace_back(asFloat(point.x()), asFloat(point.y()),
                                              asFloat(Floor + height));
                map.cloud.normals.emplace_back(asFloat(-along.y()), asFloat(along.x()), 0.0F);
            }
        }
    }
    for (double x = -2.0; x < 3.0; x += 2.0 * Step) {
        for (double y = -1.0; y < 1.0; y += 2.0 * Step) {
            map.cloud.points.emplace_back(asFloat(x), asFloat(y), asFloat(Floor));
            map.cloud.normals.emplace_back(0.0F, 0.0F, 1.0F);
        }
    }
    map.search = makeSearch(map.cloud, SearchMethod::KdTree);
    return map;
}

Pose FlatWorld::at(double x, double y, double heading) {
    return poseFrom({x, y, Floor}, 0, 0, heading);
}

RangesSample FlatWorld::ranges(const Pose& baseInMap, Time stamp, double turning) const {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.01);
    RangesSample sample;
    sample.header.stamp = stamp;
    sample.angleMin = degrees(-120);
    sample.angleStep = degrees(240.0 / (Rays - 1));
    sample.timeStep = 0.1 / Rays;
    sample.rangeMin = 0.06;
    sample.rangeMax = 4.0;
    for (int i = 0; i < Rays; ++i) {
        const Pose base = baseInMap * poseFrom({0, 0, 0}, 0, 0, turning * i * sample.timeStep);
        const Pose laser = base * laserInBase();
        const double angle = sample.angleMin + i * sample.angleStep;
        const Eigen::Vector3d along = laser.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Wall& wall : m_walls)
            nearest = std::min(nearest, distance(wall, laser.translation().head<2>(), along.head<2>()));
        sample.ranges.push_back(asFloat(nearest + noise(random)));
    }
    return sample;
}

LaserView FlatWorld::view(const Pose& baseInMap, Time stamp) const {
    return laserView(ranges(baseInMap, stamp), laserInBase(), {});
}

}  // namespace leitstand::test
