#include "core/mapping/placement/own_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr std::size_t MostViews = 40, LastViews = 8;
constexpr double Apart = 0.3, TurnedApart = degrees(20);  ///< between views that are kept [m], [rad]
constexpr std::size_t Aside = 3;                          ///< points to either side that define a direction
constexpr float Together = 0.08F, PerMetre = 0.03F;  ///< between neighbours on a wall, by range [m], [m / m]
constexpr float Spacing = 0.04F;                     ///< between points that are kept [m]

/// Returns the normal of the wall at point @p i; zero where it is unknown.
Eigen::Vector2f normalAt(const std::vector<Eigen::Vector2f>& points, std::size_t i) {
    if (i < Aside || i + Aside >= points.size()) return Eigen::Vector2f::Zero();
    const float gap = Together + PerMetre * points[i].norm();
    for (std::size_t k = i - Aside; k < i + Aside; ++k) {
        if ((points[k + 1] - points[k]).norm() > gap) return Eigen::Vector2f::Zero();
    }
    const Eigen::Vector2f along = points[i + Aside] - points[i - Aside];
    const Eigen::Vector2f off = points[i] - points[i - Aside];
    const float length = along.norm();
    if (length < 1e-3F) return Eigen::Vector2f::Zero();
    const Eigen::Vector2f normal(-along.y() / length, along.x() / length);
    if (std::abs(normal.dot(off)) > Together / 2) return Eigen::Vector2f::Zero();  // a corner
    return normal.dot(points[i]) > 0.0F ? Eigen::Vector2f(-normal) : normal;       // towards the robot
}

double turnBetween(const FlatPose& a, const FlatPose& b) {
    return std::abs(std::remainder(a.heading - b.heading, 2.0 * std::numbers::pi));
}

}  // namespace

void OwnWalls::add(const LaserView& view, const FlatPose& place) {
    const bool known = std::any_of(m_views.begin(), m_views.end(), [&](const View& there) {
        return (there.place.place - place.place).norm() < Apart &&
               turnBetween(there.place, place) < TurnedApart;
    });
    if (known) return;
    View kept{place, {}, {}};
    for (std::size_t i = 0; i < view.points.size(); ++i) {
        if (!kept.points.empty() && (view.points[i] - kept.points.back()).norm() < Spacing) continue;
        const Eigen::Vector2f normal = normalAt(view.points, i);
        if (normal.isZero()) continue;
        kept.points.push_back(view.points[i]);
        kept.normals.push_back(normal);
    }
    m_views.push_back(std::move(kept));
    if (m_views.size() <= MostViews) return;
    m_views.pop_front();
    if (m_settled > 0) --m_settled;
    if (m_chain > 0) --m_chain;
}

void OwnWalls::correct(const FlatPose& taken, const FlatPose& found) {
    const double turn = found.heading - taken.heading;
    for (std::size_t i = m_settled; i < m_views.size(); ++i) {
        FlatPose& place = m_views[i].place;
        place.place = found.place + Eigen::Rotation2Dd(turn) * (place.place - taken.place);
        place.heading += turn;
    }
}

void OwnWalls::forget() {
    m_views.clear();
    m_settled = m_chain = 0;
}

LaserView OwnWalls::seenFrom(const FlatPose& place, const LaserView& newest) const {
    LaserView all = newest;
    const std::size_t since = std::max(m_settled, m_chain);
    const std::size_t first = std::max(since, m_views.size() - std::min(m_views.size(), LastViews));
    const Eigen::Rotation2Dd back(-place.heading);
    for (std::size_t i = first; i < m_views.size(); ++i) {
        for (const Eigen::Vector2f& point : m_views[i].points)
            all.points.push_back(
                (back * (m_views[i].place * point.cast<double>() - place.place)).cast<float>());
    }
    return all;
}

WallMap OwnWalls::with(const WallMap& map) const {
    WallMap both;
    both.ground = map.ground;
    both.walls.points = map.walls.points;
    both.walls.normals = map.walls.normals;
    for (const View& view : m_views) {
        const Eigen::Rotation2Df turned(static_cast<float>(view.place.heading));
        const Eigen::Vector2f at = view.place.place.cast<float>();
        for (std::size_t i = 0; i < view.points.size(); ++i) {
            const Eigen::Vector2f point = at + turned * view.points[i], normal = turned * view.normals[i];
            both.walls.points.emplace_back(point.x(), point.y(), 0.0F);
            both.walls.normals.emplace_back(normal.x(), normal.y(), 0.0F);
        }
    }
    if (!both.walls.points.empty()) both.search = makeSearch(both.walls, SearchMethod::KdTree);
    return both;
}

}  // namespace leitstand
