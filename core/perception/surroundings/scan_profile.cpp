#include "core/perception/surroundings/scan_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leitstand {
namespace {

constexpr double Upright = 0.15;  // points so near above each other are of one object [m]

/// Follows the floor outwards along a raw scan.
class FloorFollower {
public:
    explicit FloorFollower(const ProfileSettings& settings)
        : m_settings(settings), m_climb(std::tan(settings.climb)) {}

    /// Whether a ramp that the robot climbs leads from the floor so far to @p point, up to a step.
    [[nodiscard]] bool reaches(const ProfilePoint& point) const {
        return point.height <= m_lowest + m_climb * point.distance + m_settings.step;
    }
    /// Whether the floor breaks off before @p point: it is more than the allowed drop below a climbable ramp
    /// down from edge(). Stairs break off too, although none of their steps is that deep.
    [[nodiscard]] bool breaksBefore(const ProfilePoint& point) const {
        return rampDownTo(point) < rampDownTo(m_edge) - m_settings.drop;
    }
    void add(const ProfilePoint& point) {
        if (rampDownTo(point) >= rampDownTo(m_edge)) m_edge = point;
        m_lowest = std::min(m_lowest, point.height - m_climb * point.distance);
        m_floor.push_back({point.distance, point.height});
    }
    /// Height of the floor at @p distance: of the farthest floor before it.
    [[nodiscard]] double at(double distance) const {
        double height = 0.0, best = 0.0;
        for (const auto& [floorDistance, floorHeight] : m_floor) {
            if (floorDistance > distance || floorDistance < best) continue;
            best = floorDistance;
            height = floorHeight;
        }
        return height;
    }
    /// The floor point from which the steepest ramp down reaches beyond those of all others.
    [[nodiscard]] const ProfilePoint& edge() const { return m_edge; }

private:
    /// Height at the robot's place of the steepest ramp down to @p point.
    [[nodiscard]] double rampDownTo(const ProfilePoint& point) const {
        return point.height + m_climb * point.distance;
    }

    const ProfileSettings& m_settings;
    double m_climb;
    double m_lowest = 0.0;  ///< least of height - climb * distance: where the steepest ramp would begin
    ProfilePoint m_edge;    ///< begins at the robot's own ground
    std::vector<std::pair<double, double>> m_floor;  ///< distance, height
};

bool isBeside(const ProfilePoint& a, const ProfilePoint& b, const ProfileSettings& settings) {
    const double reach = settings.support + settings.supportRate * a.distance;
    return std::abs(a.distance - b.distance) < reach && std::abs(a.height - b.height) < reach;
}

/// Whether another point is near points[i], in its raw scan or in the one beside it.
bool isSupported(std::span<const ProfilePoint> points, std::size_t i, std::span<const ProfilePoint> neighbour,
                 const ProfileSettings& settings) {
    constexpr std::size_t Reach = 2;  // points before and after
    const std::size_t first = i < Reach ? 0 : i - Reach;
    for (std::size_t k = first; k < std::min(points.size(), i + Reach + 1); ++k) {
        if (k != i && isBeside(points[i], points[k], settings)) return true;
    }
    return std::any_of(neighbour.begin(), neighbour.end(),
                       [&](const ProfilePoint& one) { return isBeside(points[i], one, settings); });
}

}  // namespace

ProfileContour contourOf(std::span<const ProfilePoint> points, std::span<const ProfilePoint> neighbour,
                         const ProfileSettings& settings) {
    ProfileContour contour;
    FloorFollower floor(settings);
    const auto offer = [&contour](const ProfilePoint& point) {
        if (!contour.inner || point.distance < contour.inner->distance) contour.inner = point;
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ProfilePoint& point = points[i];
        if (point.height < settings.wallHeight &&
            (!contour.outer || point.distance > contour.outer->distance)) {
            contour.outer = point;
        }
        if (floor.reaches(point)) {
            const bool broken = floor.breaksBefore(point);
            // One low point may be mixed or mirrored; two are a hole.
            if (broken && (i + 1 >= points.size() || !floor.breaksBefore(points[i + 1]))) continue;
            if (broken) offer(floor.edge().distance > 0.0 ? floor.edge() : point);
            floor.add(point);
            continue;
        }
        if (contour.inner && point.distance >= contour.inner->distance) continue;
        const double over = point.height - floor.at(point.distance);
        if (over > settings.height || over < settings.step) continue;
        if (isSupported(points, i, neighbour, settings)) offer(point);
    }
    if (!contour.inner) return contour;
    const double ground = floor.at(contour.inner->distance);
    contour.innerBottom = std::max(0.0, contour.inner->height - ground);
    for (const ProfilePoint& point : points) {
        if (std::abs(point.distance - contour.inner->distance) >= Upright) continue;
        const double over = point.height - ground;
        contour.innerTop = std::max(contour.innerTop, over);
        if (over >= settings.step) contour.innerBottom = std::min(contour.innerBottom, over);
    }
    return contour;
}

}  // namespace leitstand
