#include "core/mapping/plane/plane_scan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "core/cloud/filters/voxel_grid.h"
#include "core/event/cloud_sample.h"

namespace leitstand {
namespace {

constexpr double LongestTurn = 1.0;   ///< [s]
constexpr double Edge = 0.15;         ///< least jump between two surfaces [m] ...
constexpr double EdgeOfRange = 0.03;  ///< ... plus this share of the range
constexpr float WallHeight = 0.4F;    ///< of points of a wall over and below the laser's plane [m]

constexpr float Beside = 0.15F;  ///< neighbours within this of a point show its wall's direction [m] ...
constexpr float BesideOfRange = 0.06F;     ///< ... plus this share of the range: noise grows with it
constexpr std::ptrdiff_t MostBeside = 24;  ///< on each side
constexpr float LineBelow = 0.2F;  ///< a wall's points spread so much less across it than along it, squared

/// Returns whether the ray at @p i hit the edge of a surface before another one: its range lies between.
bool hitsEdge(const RangesSample& ranges, std::size_t i) {
    if (i == 0 || i + 1 >= ranges.ranges.size()) return false;
    const float before = ranges.ranges[i - 1], here = ranges.ranges[i], after = ranges.ranges[i + 1];
    const auto jump = static_cast<float>(Edge + EdgeOfRange * double{here});
    return (here - before > jump && after - here > jump) || (before - here > jump && here - after > jump);
}

/// A point on the wall that it was measured on.
struct OnWall {
    Eigen::Vector3f point;                             ///< without the noise across the wall
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< towards the laser; zero: no wall is known
};

/// Returns @p points[i] on the line through the points about it.
OnWall onWall(std::span<const Eigen::Vector3f> points, std::size_t i) {
    const Eigen::Vector2f middle = points[i].head<2>();
    const float within = Beside + BesideOfRange * middle.norm();
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    Eigen::Vector2f sum = Eigen::Vector2f::Zero();
    Eigen::Matrix2f squares = Eigen::Matrix2f::Zero();
    int found = 0;
    for (const std::ptrdiff_t side : {-1, 1}) {
        // The rays of a whole turn go on at its other end.
        for (std::ptrdiff_t step = side < 0 ? 1 : 0; step <= std::min(MostBeside, count / 2); ++step) {
            const auto at = (static_cast<std::ptrdiff_t>(i) + side * step + count) % count;
            const Eigen::Vector2f apart = points[static_cast<std::size_t>(at)].head<2>() - middle;
            if (apart.norm() > within) continue;
            sum += apart;
            squares += apart * apart.transpose();
            ++found;
        }
    }
    if (found < 3) return {points[i]};
    const float each = 1.0F / static_cast<float>(found);
    const Eigen::Vector2f mean = each * sum;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2f> axes(each * squares - mean * mean.transpose());
    if (!(axes.eigenvalues()[0] < LineBelow * axes.eigenvalues()[1])) return {points[i]};
    const Eigen::Vector2f across = axes.eigenvectors().col(0);
    const Eigen::Vector2f there = middle + across.dot(mean) * across;
    const Eigen::Vector2f normal = across.dot(middle) > 0.0F ? Eigen::Vector2f(-across) : across;
    return {{there.x(), there.y(), 0.0F}, {normal.x(), normal.y(), 0.0F}};
}

}  // namespace

Pose uprightLaser(const Pose& laserInBase) {
    if (laserInBase.linear()(2, 2) >= 0.0) return laserInBase;
    return laserInBase * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
}

bool isLevel(const Pose& laserInBase) {
    constexpr double MostTilt = degrees(20);
    return std::abs(laserInBase.linear()(2, 2)) > std::cos(MostTilt);
}

CloudSample cloudOf(const RangesSample& ranges, const Pose& laserInBase) {
    CloudSample cloud;
    cloud.header = ranges.header;
    const double over = laserInBase.linear()(2, 2) >= 0.0 ? 1.0 : -1.0;
    const double turn = ranges.timeStep * static_cast<double>(ranges.ranges.size());
    const bool timed = ranges.timeStep > 0.0 && turn <= LongestTurn;
    const bool bounded = ranges.rangeMax > 0.0;
    const bool bright = ranges.intensities.size() == ranges.ranges.size();
    cloud.points.reserve(ranges.ranges.size());
    for (std::size_t i = 0; i < ranges.ranges.size(); ++i) {
        const double range{ranges.ranges[i]}, ray = static_cast<double>(i);
        if (!(range > 0.0 && range >= ranges.rangeMin) || std::isinf(range)) continue;
        if ((bounded && range > ranges.rangeMax) || hitsEdge(ranges, i)) continue;
        const double angle = ranges.angleMin + ray * ranges.angleStep;
        if (!std::isfinite(angle)) continue;
        cloud.points.emplace_back(static_cast<float>(range * std::cos(angle)),
                                  static_cast<float>(over * range * std::sin(angle)), 0.0F);
        if (bright) cloud.intensities.push_back(ranges.intensities[i]);
        if (timed) cloud.times.push_back(std::llround(1e9 * ray * ranges.timeStep));
    }
    return cloud;
}

PointCloud wallsAndFloor(std::span<const Eigen::Vector3f> points, double edge) {
    PointCloud echoes;
    echoes.points.reserve(points.size());
    echoes.normals.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const OnWall echo = onWall(points, i);
        echoes.points.push_back(echo.point);
        echoes.normals.push_back(echo.normal);
    }
    const PointCloud squares =
        voxelGrid(echoes, edge, VoxelPoint::Centroid, ownGridOrigin(echoes.points, edge));
    PointCloud cloud;
    cloud.points.reserve(3 * squares.size());
    cloud.normals.reserve(3 * squares.size());
    for (std::size_t i = 0; i < squares.size(); ++i) {
        for (const float height : {-WallHeight, WallHeight}) {
            cloud.points.emplace_back(squares.points[i] + height * Eigen::Vector3f::UnitZ());
            cloud.normals.push_back(squares.normals[i]);
        }
        cloud.points.push_back(squares.points[i]);
        cloud.normals.emplace_back(Eigen::Vector3f::UnitZ());
    }
    return cloud;
}

}  // namespace leitstand
