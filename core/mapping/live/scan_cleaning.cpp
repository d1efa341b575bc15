#include "core/mapping/live/scan_cleaning.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "core/event/scan_bodies.h"

namespace leitstand {
namespace {

const Eigen::Vector3f NoEcho = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());

constexpr double Ground = 0.05;  ///< lower points belong to the world [m]
constexpr double Above = 0.3;    ///< a thing taller than a robot has points so near above it [m]
constexpr double Bare = 0.03;    ///< nothing else has room so near to a footprint [m]
constexpr double Column = 0.08;  ///< edge of a column in which such a thing stands [m]

/// Returns whether @p point is within the polygon @p corners (crossings of a ray along x).
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

/// Columns around a robot that hold something taller than it, seen from above.
class TallColumns {
public:
    void add(const Eigen::Vector2d& place) {
        const auto [x, y] = cellOf(place);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) m_cells.emplace(x + dx, y + dy);
        }
    }
    [[nodiscard]] bool contain(const Eigen::Vector2d& place) const { return m_cells.contains(cellOf(place)); }

private:
    static std::pair<int, int> cellOf(const Eigen::Vector2d& place) {
        return {static_cast<int>(std::floor(place.x() / Column)),
                static_cast<int>(std::floor(place.y() / Column))};
    }
    std::set<std::pair<int, int>> m_cells;
};

/// A point near a robot, in its base frame.
struct NearPoint {
    std::size_t index;
    Eigen::Vector2d place;
};

/// Returns those of @p points, in a frame at @p inBase, that are on or within @p other.
std::vector<std::size_t> pointsOn(const PlacedBody& other, std::span<const Eigen::Vector3f> points,
                                  const Pose& inBase) {
    const RobotBody& body = other.body;
    if (body.footprint.empty()) return {};
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : body.footprint) box.extend(corner);
    box.extend(box.min() - Eigen::Vector2d::Constant(other.margin));
    box.extend(box.max() + Eigen::Vector2d::Constant(other.margin));
    const double top = body.height + PlacedBody::Certain;
    // Most points are far and need no closer look.
    const double corner = std::max(box.min().norm(), box.max().norm()) + 0.5 * box.diagonal().norm();
    const auto reach = static_cast<float>(std::hypot(corner, top + Above));
    const Eigen::Vector3f centre = inBase.inverse().translation().cast<float>();
    TallColumns tall;
    std::vector<NearPoint> near;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!((points[i] - centre).squaredNorm() <= reach * reach)) continue;  // NaN is no echo
        const Eigen::Vector3d point = inBase * points[i].cast<double>();
        const Eigen::Vector2d place = point.head<2>();
        if (point.z() < Ground || point.z() > top + Above || !box.contains(place)) continue;
        if (point.z() > top) {
            tall.add(place);
        } else if (onFootprint(body, place, other.margin)) {
            near.push_back({i, place});
        }
    }
    const bool certain = other.margin <= PlacedBody::Certain;
    std::vector<std::size_t> on;
    for (const NearPoint& point : near) {
        if (!tall.contain(point.place) || (certain && onFootprint(body, point.place, Bare)))
            on.push_back(point.index);
    }
    return on;
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
        if (inBase.z() < Ground || inBase.z() > body.height + margin) continue;
        const Eigen::Vector2d place = inBase.head<2>();
        if (!box.contains(place)) continue;
        if (onFootprint(body, place, margin)) point = NoEcho;
    }
}

std::vector<bool> onOthers(std::span<const Eigen::Vector3f> points, std::span<const PlacedBody> others,
                           const Pose& scanInMap) {
    std::vector<bool> found(points.size(), false);
    for (const PlacedBody& other : others) {
        for (const std::size_t point : pointsOn(other, points, other.baseInMap.inverse() * scanInMap))
            found[point] = true;
    }
    return found;
}

std::vector<PlacedBody> placed(std::span<const BodyInScan> bodies, const Pose& scanInMap) {
    std::vector<PlacedBody> there;
    there.reserve(bodies.size());
    for (const BodyInScan& body : bodies)
        there.push_back({{body.footprint, body.height}, scanInMap * body.baseInScan, body.margin});
    return there;
}

std::vector<BodyInScan> inScan(const std::string& robot, std::span<const PlacedBody> bodies,
                               const Pose& scanInMap) {
    std::vector<BodyInScan> there;
    there.reserve(bodies.size());
    for (const PlacedBody& one : bodies)
        there.push_back(
            {robot, one.body.footprint, one.body.height, scanInMap.inverse() * one.baseInMap, one.margin});
    return there;
}

void leaveOutBodies(Scan& scan, std::span<const PlacedBody> others, const Pose& scanInMap) {
    if (others.empty()) return;
    const std::vector<bool> on = onOthers(scan.points, others, scanInMap);
    for (std::size_t i = 0; i < on.size(); ++i) {
        if (on[i]) scan.points[i] = NoEcho;
    }
}

void leaveOutCropped(Scan& scan, const MapCrop& crop, const Pose& scanInMap) {
    if (crop.open()) return;
    for (Eigen::Vector3f& point : scan.points) {
        if (point.allFinite() && !crop.contains(scanInMap * point.cast<double>())) point = NoEcho;
    }
}

}  // namespace leitstand
