#include "core/mapping/placement/laser_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/rotation/heading.h"
#include "core/cloud/filters/cell_table.h"
#include "core/mapping/walls/flat_pose.h"

namespace leitstand {
namespace {

constexpr double Ground = 0.07;  ///< lower points are floor [m]
constexpr double Below = 0.06,
                 Above = 0.25;            ///< around a laser's plane, which is tilted a little [m]
constexpr double Low = 0.12, High = 0.6;  ///< of a 3D scan [m]
constexpr double Farthest = 40.0;         ///< points beyond are not used [m]
constexpr double Edge = 0.05;             ///< of the squares that points are thinned to [m]

/// Returns @p base turned about its place so that it is level, with the same heading.
Pose level(const Pose& base) {
    return poseFrom(base.translation(), 0.0, 0.0, headingOf(base));
}

/// Keeps one point per square.
class Thinned {
public:
    explicit Thinned(LaserView& view) : m_view(view) {}
    void add(const Eigen::Vector3d& point) {
        const Eigen::Vector3f flat(static_cast<float>(point.x()), static_cast<float>(point.y()), 0.0F);
        if (!(flat.norm() < Farthest)) return;
        if (m_cells.cellOf(flat) == m_view.points.size()) m_view.points.emplace_back(flat.x(), flat.y());
    }

private:
    LaserView& m_view;
    detail::CellTable m_cells{Edge};
};

}  // namespace

void leaveOut(LaserView& view, const Pose& baseInMap, std::span<const Disc> discs) {
    const FlatPose at = FlatPose::of(baseInMap);
    std::erase_if(view.points, [&](const Eigen::Vector2f& point) {
        return std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
            return (at * point.cast<double>() - disc.middle).norm() < disc.radius;
        });
    });
}

void leaveOutCropped(LaserView& view, const Pose& baseInMap, const MapCrop& crop) {
    if (crop.open()) return;
    const FlatPose at = FlatPose::of(baseInMap);
    const double height = baseInMap.translation().z() + view.low;
    std::erase_if(view.points, [&](const Eigen::Vector2f& point) {
        const Eigen::Vector2d place = at * point.cast<double>();
        return !crop.contains({place.x(), place.y(), height});
    });
}

LaserView laserView(const RangesSample& ranges, const Pose& laserInBase, const MotionBuffer& motion) {
    LaserView view;
    const auto rays = static_cast<double>(ranges.ranges.size());
    const auto after = [&](double ray) {
        return ranges.header.stamp + std::chrono::nanoseconds(std::llround(1e9 * ray * ranges.timeStep));
    };
    view.stamp = after(std::max(0.0, rays - 1.0));
    const auto poseAt = [&](Time stamp) {
        const auto known = motion.at(stamp);
        return known ? known->baseInOdom : Pose::Identity();
    };
    const bool moves = motion.at(view.stamp).has_value() && motion.at(after(0.0)).has_value();
    const Pose end = poseAt(view.stamp), begin = moves ? poseAt(after(0.0)) : end;
    const Pose flat = level(end);
    view.tilt = flat.inverse() * end;
    const double height = (view.tilt * laserInBase).translation().z();
    view.low = std::max(Ground, height - Below);
    view.high = height + Above;
    const double farthest = ranges.rangeMax > 0.0 ? ranges.rangeMax : Farthest;  // 0: not given
    Thinned kept(view);
    for (std::size_t i = 0; i < ranges.ranges.size(); ++i) {
        const double range = double{ranges.ranges[i]}, ray = static_cast<double>(i);
        if (!(range > 0.0 && range >= ranges.rangeMin && range <= farthest)) continue;
        const double angle = ranges.angleMin + ray * ranges.angleStep;
        const Pose base = interpolated(begin, end, rays > 1.0 ? ray / (rays - 1.0) : 1.0);
        const Eigen::Vector3d inLaser(range * std::cos(angle), range * std::sin(angle), 0.0);
        const Eigen::Vector3d point = flat.inverse() * (base * (laserInBase * inLaser));
        if (point.z() > Ground) kept.add(point);
    }
    return view;
}

LaserView laserView(const LiveScan& live) {
    LaserView view;
    view.stamp = live.scan->end;
    view.low = Low;
    view.high = High;
    const auto up = (live.sensorInBase.linear() * live.up).normalized();
    view.tilt.linear() = Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Pose sensor = view.tilt * live.sensorInBase;
    if (live.plane) {
        view.low = std::max(Ground, sensor.translation().z() - Below);
        view.high = sensor.translation().z() + Above;
    }
    Thinned kept(view);
    for (const Eigen::Vector3f& one : live.scan->points) {
        if (!one.allFinite()) continue;
        const Eigen::Vector3d point = sensor * one.cast<double>();
        if (point.z() > view.low && point.z() < view.high) kept.add(point);
    }
    return view;
}

}  // namespace leitstand
