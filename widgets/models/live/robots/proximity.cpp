#include "widgets/models/live/robots/proximity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace leitstand {
namespace {

constexpr int Parts = 8;
constexpr double Width = 2.0 * std::numbers::pi / Parts;

/// Returns how fast the robot approaches what is at @p where [m/s].
double approach(const Eigen::Vector2d& where, const DriveVelocity& velocity) {
    const Eigen::Vector2d motion(velocity.forward, velocity.left);
    return where.norm() > 1e-6 ? std::max(0.0, motion.dot(where.normalized())) : 0.0;
}

Nearness nearnessOf(const Proximity& part, const DriveVelocity& velocity, const ProximityLimits& limits) {
    if (!part.where) return Nearness::Far;
    if (part.distance <= limits.touching) return Nearness::Touching;
    const double reach = limits.near + limits.ahead * approach(*part.where, velocity);
    return part.distance <= reach ? Nearness::Near : Nearness::Far;
}

}  // namespace

double distanceFrom(const BodyBox& body, const Eigen::Vector2d& point) {
    const double x = std::max({point.x() - body.front, -body.back - point.x(), 0.0});
    const double y = std::max({point.y() - body.left, -body.right - point.y(), 0.0});
    return std::hypot(x, y);
}

std::vector<Proximity> proximityRing(const VirtualScanView& view, const BodyBox& body,
                                     const DriveVelocity& velocity, const ProximityLimits& limits) {
    std::vector<Proximity> ring(Parts);
    const auto partOf = [](double direction) {
        return static_cast<std::size_t>((static_cast<int>(std::lround(direction / Width)) + Parts) % Parts);
    };
    std::vector<int> sectors(Parts, 0), seen(Parts, 0);
    for (int i = 0; i < static_cast<int>(view.sectors.size()); ++i) {
        const std::size_t part = partOf(view.directionOf(i));
        ++sectors[part];
        if (view.sectors[static_cast<std::size_t>(i)].age <= limits.maxAge) ++seen[part];
    }
    for (const VirtualObstacle& one : view.obstacles) {
        if (!(one.age <= limits.maxAge) || !one.where.allFinite()) continue;
        Proximity& part = ring[partOf(std::atan2(one.where.y(), one.where.x()))];
        const double distance = distanceFrom(body, one.where);
        if (part.where && distance >= part.distance) continue;
        part.where = one.where;
        part.distance = distance;
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        ring[i].from = (static_cast<double>(i) - 0.5) * Width;
        ring[i].to = ring[i].from + Width;
        // A part that was not looked at is never called free; what was seen there still counts.
        const bool known = ring[i].where || 2 * seen[i] > sectors[i];
        ring[i].nearness = known ? nearnessOf(ring[i], velocity, limits) : Nearness::Unknown;
    }
    return ring;
}

const Proximity* nearestOf(const std::vector<Proximity>& ring) {
    const auto best = std::min_element(ring.begin(), ring.end(), [](const Proximity& a, const Proximity& b) {
        return a.distance < b.distance;
    });
    return best == ring.end() || !best->where ? nullptr : &*best;
}

}  // namespace leitstand
