#include "robots/simulation/world/motion/resting_plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>

namespace leitstand::simulation {
namespace {

constexpr double Touches = 1e-7;       ///< a point this little above the plane counts as on it [m]
constexpr double SmallestArea = 1e-7;  ///< of a triangle of feet, doubled [m2]
constexpr int MaxExchanges = 200;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Returns the shares of a weight on three points; empty when it is not between them.
std::optional<std::array<double, 3>> sharesOf(std::span<const Eigen::Vector3d> points,
                                              const std::array<int, 3>& feet, const Eigen::Vector2d& weight) {
    const auto foot = [&](std::size_t i) -> Eigen::Vector2d {
        return points[static_cast<std::size_t>(feet[i])].head<2>();
    };
    const Eigen::Vector2d a = foot(0), ab = foot(1) - a, ac = foot(2) - a, aw = weight - a;
    const double area = cross(ab, ac);
    if (std::abs(area) < SmallestArea) return std::nullopt;
    const double b = cross(aw, ac) / area, c = cross(ab, aw) / area;
    constexpr double Edge = -1e-9;
    if (b < Edge || c < Edge || 1.0 - b - c < Edge) return std::nullopt;
    return std::array<double, 3>{1.0 - b - c, b, c};
}

/// Returns the corners of the points' outline, counter-clockwise (Andrew 1979).
std::vector<int> hullOf(std::span<const Eigen::Vector3d> points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](int i) -> Eigen::Vector2d { return points[static_cast<std::size_t>(i)].head<2>(); };
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const Eigen::Vector2d p = at(a), q = at(b);
        return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    });
    std::vector<int> hull;
    const auto add = [&](int i, std::size_t keep) {
        while (hull.size() >= keep + 2 &&
               cross(at(hull.back()) - at(hull[hull.size() - 2]), at(i) - at(hull.back())) <= 0.0) {
            hull.pop_back();
        }
        hull.push_back(i);
    };
    for (const int i : order) add(i, 0);
    const std::size_t lower = hull.size() - 1;
    for (std::size_t i = order.size(); i-- > 0;) {
        if (order[i] != hull.back()) add(order[i], lower);
    }
    hull.pop_back();
    return hull;
}

std::optional<std::array<int, 3>> anyFeet(std::span<const Eigen::Vector3d> points,
                                          const Eigen::Vector2d& weight) {
    const std::vector<int> hull = hullOf(points);
    for (std::size_t i = 2; i < hull.size(); ++i) {
        const std::array<int, 3> feet = {hull[0], hull[i - 1], hull[i]};
        if (sharesOf(points, feet, weight)) return feet;
    }
    return std::nullopt;
}

void fit(RestingPlane& plane, std::span<const Eigen::Vector3d> points) {
    const Eigen::Vector3d& a = points[static_cast<std::size_t>(plane.feet[0])];
    const Eigen::Vector3d ab = points[static_cast<std::size_t>(plane.feet[1])] - a;
    const Eigen::Vector3d ac = points[static_cast<std::size_t>(plane.feet[2])] - a;
    const Eigen::Vector3d normal = ab.cross(ac);
    plane.slope = -normal.head<2>() / normal.z();
    plane.height = a.z() - plane.slope.dot(a.head<2>());
}

}  // namespace

std::optional<RestingPlane> restingPlane(std::span<const Eigen::Vector3d> points,
                                         const Eigen::Vector2d& weight, const std::array<int, 3>& guess) {
    if (points.size() < 3) return std::nullopt;
    RestingPlane plane;
    plane.feet = guess;
    auto shares = sharesOf(points, plane.feet, weight);
    if (!shares) {
        const auto feet = anyFeet(points, weight);
        if (!feet) return std::nullopt;
        plane.feet = *feet;
        shares = sharesOf(points, plane.feet, weight);
    }
    plane.shares = *shares;
    fit(plane, points);
    // A point above the plane makes three triangles with two of the feet. One of them has the weight in it,
    // and its plane is higher under the weight. Feet are exchanged until no point is above.
    for (int exchange = 0; exchange < MaxExchanges; ++exchange) {
        int highest = -1;
        double above = Touches;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double excess = points[i].z() - plane.at(points[i].head<2>());
            if (excess > above) {
                above = excess;
                highest = static_cast<int>(i);
            }
        }
        if (highest < 0) break;
        std::optional<RestingPlane> best;
        for (std::size_t leaving = 0; leaving < 3; ++leaving) {
            RestingPlane next = plane;
            next.feet[leaving] = highest;
            const auto nextShares = sharesOf(points, next.feet, weight);
            if (!nextShares) continue;
            next.shares = *nextShares;
            fit(next, points);
            if (!best || next.at(weight) > best->at(weight)) best = next;
        }
        if (!best || best->at(weight) < plane.at(weight) - Touches) break;
        plane = *best;
    }
    return plane;
}

}  // namespace leitstand::simulation
