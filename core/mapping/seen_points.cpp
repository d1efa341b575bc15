#include "core/mapping/seen_points.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/event/cloud_sample.h"

namespace leitstand {
namespace {

constexpr double BodyMargin = 0.06;  // points so near to the robot are its own [m]
constexpr double Nearest = 0.15;     // a camera shows nothing nearer [m]
constexpr double Split = 0.25;       // gap between surfaces along a ray [m]
constexpr double Enough = 0.9;       // weight of the points of a surface
constexpr std::size_t Fewest = 2;    // ... and their number
constexpr double Front = 0.35;       // share of the weight of the heaviest surface
constexpr int Widenings = 3;
constexpr double Widening = 1.45;

struct Met {
    double range, weight;
};

/// Points of one surface.
struct Surface {
    std::size_t begin = 0, end = 0;
    double weight = 0.0;
};

/// Returns the nearest surface that many of @p met (by rising ranges) are on. It hides what is behind, though
/// a scanner that sits higher than the camera sees that too.
Surface frontSurface(const std::vector<Met>& met) {
    std::vector<Surface> surfaces;
    double most = 0.0;
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (i == 0 || met[i].range - met[i - 1].range > Split) surfaces.push_back({i, i, 0.0});
        surfaces.back().end = i + 1;
        surfaces.back().weight += met[i].weight;
        most = std::max(most, surfaces.back().weight);
    }
    for (const Surface& one : surfaces) {
        if (one.weight >= Front * most && one.weight >= Enough && one.end - one.begin >= Fewest) return one;
    }
    return {};
}

RayHit hitOf(const std::vector<Met>& met, const Surface& surface) {
    RayHit hit;
    double sum = 0.0;
    for (std::size_t i = surface.begin; i < surface.end; ++i) {
        sum += met[i].weight;
        hit.range = met[i].range;
        if (sum >= surface.weight / 2.0) break;
    }
    double squares = 0.0;
    for (std::size_t i = surface.begin; i < surface.end; ++i)
        squares += met[i].weight * std::pow(met[i].range - hit.range, 2);
    hit.scatter = std::sqrt(squares / surface.weight);
    hit.points = static_cast<int>(surface.end - surface.begin);
    return hit;
}

}  // namespace

SeenPoints::SeenPoints(RobotBody body) : m_body(std::move(body)) {}

bool SeenPoints::isOwn(const Eigen::Vector3d& inBase) const {
    if (m_body.footprint.empty() || inBase.z() > m_body.height + BodyMargin) return false;
    Eigen::Vector2d low = m_body.footprint.front(), high = low;
    for (const Eigen::Vector2d& corner : m_body.footprint) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    const Eigen::Vector2d flat = inBase.head<2>(), margin(BodyMargin, BodyMargin);
    return ((flat - low + margin).array() > 0.0).all() && ((high + margin - flat).array() > 0.0).all();
}

void SeenPoints::keep(Time stamp, std::vector<Eigen::Vector3f> points) {
    // A clock that jumped back starts again.
    if (!m_chunks.empty() && stamp < m_chunks.back().stamp - 10 * Memory) m_chunks.clear();
    if (!points.empty()) m_chunks.push_back({stamp, std::move(points)});
    while (!m_chunks.empty() && m_chunks.front().stamp < stamp - Memory) m_chunks.pop_front();
}

void SeenPoints::add(const CloudSample& slice, const Pose& sensorInBase, const PoseAt& baseInOdom) {
    std::vector<Eigen::Vector3f> points;
    std::optional<Pose> base;
    std::optional<Time> of;
    for (std::size_t i = 0; i < slice.points.size(); ++i) {
        const Eigen::Vector3f& point = slice.points[i];
        if (!point.allFinite()) continue;
        const Time at =
            slice.header.stamp + std::chrono::nanoseconds(i < slice.times.size() ? slice.times[i] : 0);
        if (of != at) {
            base = baseInOdom(at);
            of = at;
        }
        const Eigen::Vector3d inBase = sensorInBase * point.cast<double>();
        if (base && !isOwn(inBase)) points.emplace_back((*base * inBase).cast<float>());
    }
    keep(slice.header.stamp, std::move(points));
}

void SeenPoints::add(const RangesSample& turn, const Pose& sensorInBase, const PoseAt& baseInOdom) {
    std::vector<Eigen::Vector3f> points;
    const auto base = baseInOdom(turn.header.stamp);
    if (!base) return;
    for (std::size_t i = 0; i < turn.ranges.size(); ++i) {
        const auto range = static_cast<double>(turn.ranges[i]);
        if (!(range >= turn.rangeMin && range <= turn.rangeMax)) continue;
        const double angle = turn.angleMin + static_cast<double>(i) * turn.angleStep;
        const Eigen::Vector3d inBase =
            sensorInBase * Eigen::Vector3d(range * std::cos(angle), range * std::sin(angle), 0.0);
        if (!isOwn(inBase)) points.emplace_back((*base * inBase).cast<float>());
    }
    keep(turn.header.stamp, std::move(points));
}

std::optional<RayHit> SeenPoints::meet(const Ray& ray, double halfAngle, double farthest,
                                       const Shows& shows) const {
    if (!ray.direction.allFinite() || !ray.origin.allFinite() || !(halfAngle > 0.0)) return std::nullopt;
    double widest = halfAngle * std::pow(Widening, Widenings);
    const double cosine = std::cos(std::min(widest, 1.5));
    struct Near {
        double range, angle;
    };
    std::vector<Near> near;
    for (const Chunk& chunk : m_chunks) {
        for (const Eigen::Vector3f& point : chunk.points) {
            const Eigen::Vector3d away = point.cast<double>() - ray.origin;
            const double range = away.norm(), along = away.dot(ray.direction);
            if (along < cosine * range || range < Nearest || range > farthest) continue;
            if (shows && !shows(away / range)) continue;
            near.push_back({range, std::acos(std::min(1.0, along / range))});
        }
    }
    std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.range < b.range; });
    for (int i = 0; i <= Widenings; ++i, halfAngle *= Widening) {
        std::vector<Met> met;
        for (const Near& one : near) {
            if (one.angle > halfAngle) continue;
            met.push_back({one.range, std::exp(-2.0 * std::pow(one.angle / halfAngle, 2))});
        }
        if (met.empty()) continue;
        const Surface surface = frontSurface(met);
        if (surface.end > surface.begin) return hitOf(met, surface);
    }
    return std::nullopt;
}

}  // namespace leitstand
