#include "robots/simulation/sensors/laser/laser_head.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace leitstand::simulation {
namespace {

constexpr float LeastJump = 0.06F;    ///< neighbours that differ by less have no edge between them [m]
constexpr float JumpOfRange = 0.05F;  ///< nor those by less than this share of their range
constexpr float SameNormal = 0.98F;   ///< cosine between normals of one plane
constexpr float SamePlane = 0.02F;    ///< [m]
constexpr float FullIntensity = 255.0F;

float rangeOr(const Hit& hit, double farthest) {
    return hit.there() ? hit.distance : static_cast<float>(farthest);
}

bool differ(float a, float b) {
    return std::abs(a - b) > std::max(LeastJump, JumpOfRange * std::min(a, b));
}

/// Returns whether two rays end on one plane. A floor that is met at a flat angle has no edge.
bool onOnePlane(const Hit& a, const Ray& rayOfA, const Hit& b, const Ray& rayOfB) {
    if (!a.there() || !b.there() || a.normal.dot(b.normal) < SameNormal) return false;
    const Eigen::Vector3f apart =
        (rayOfB.origin + b.distance * rayOfB.direction) - (rayOfA.origin + a.distance * rayOfA.direction);
    return std::abs(a.normal.dot(apart)) < SamePlane;
}

float cosineOf(const Hit& hit, const Ray& ray) {
    return std::abs(hit.normal.dot(ray.direction));
}

/// Returns @p direction, turned by a small @p angle [rad] towards @p neighbour.
Eigen::Vector3f turnedTowards(const Eigen::Vector3f& direction, const Eigen::Vector3f& neighbour,
                              double angle) {
    const Eigen::Vector3f across = neighbour - direction * direction.dot(neighbour);
    const float length = across.norm();
    if (!(length > 0.0F)) return direction;
    return (direction + across * (static_cast<float>(std::tan(angle)) / length)).normalized();
}

}  // namespace

bool LaserHead::returns(const Hit& hit, const Ray& ray) const {
    if (!hit.there() || hit.distance > static_cast<float>(m_settings.farthest)) return false;
    const float reflectivity = propertiesOf(hit.surface->material).reflectivity;
    if (reflectivity < m_settings.leastReflectivity) return false;
    // The light that comes back falls with the square of the range.
    const float strength = std::min(1.0F, reflectivity * cosineOf(hit, ray) / m_settings.fullReflectivity);
    return hit.distance <= static_cast<float>(m_settings.farthest) * std::sqrt(strength);
}

void LaserHead::castEdges(std::span<const Ray> rays, const CastRays& cast) {
    m_edgeOf.assign(rays.size(), -1);
    m_edgeRays.clear();
    const auto add = [&](std::size_t ray, std::size_t neighbour) {
        if (m_edgeOf[ray] >= 0) return;
        m_edgeOf[ray] = static_cast<int>(m_edgeRays.size());
        Ray edge = rays[ray];
        edge.direction = turnedTowards(edge.direction, rays[neighbour].direction, m_settings.divergence);
        m_edgeRays.push_back(edge);
    };
    for (std::size_t i = 1; i < rays.size(); ++i) {
        if (!differ(rangeOr(m_hits[i - 1], m_settings.farthest), rangeOr(m_hits[i], m_settings.farthest))) {
            continue;
        }
        if (onOnePlane(m_hits[i - 1], rays[i - 1], m_hits[i], rays[i])) continue;
        add(i - 1, i);
        add(i, i - 1);
    }
    m_edgeHits.resize(m_edgeRays.size());
    if (!m_edgeRays.empty()) cast(m_edgeRays, m_edgeHits);
}

LaserEcho LaserHead::echoOf(const Ray& ray, const Hit& hit, const Hit* edge, const Ray* edgeRay) {
    LaserEcho echo;
    const bool first = returns(hit, ray), second = edge != nullptr && returns(*edge, ray);
    if (!first && !second) return echo;
    const Hit& chosen = first ? hit : *edge;
    double range = chosen.distance;
    if (first && second && differ(hit.distance, edge->distance) && !onOnePlane(hit, ray, *edge, *edgeRay)) {
        echo.mixed = true;
        // Surfaces near each other melt into one echo between them; of others the receiver takes the
        // stronger.
        const double share = 0.5 * m_noise.uniform();
        const double apart = double{edge->distance} - double{hit.distance};
        if (std::abs(apart) < m_settings.blendLength) range += share * apart;
    } else if (!first) {
        echo.mixed = true;
        if (m_noise.uniform() < 0.5) return {};  // half a beam is often too weak
    }
    const double deviation = m_settings.deviation + m_settings.deviationOfRange * range;
    range += deviation * m_noise.normal();
    if (range < m_settings.nearest || range > m_settings.farthest) return {};
    echo.range = static_cast<float>(range);
    const float strength = propertiesOf(chosen.surface->material).reflectivity * cosineOf(chosen, ray);
    const float noise = 1.0F + m_settings.intensityDeviation * static_cast<float>(m_noise.normal());
    echo.intensity = std::clamp(FullIntensity * strength * noise, 0.0F, FullIntensity);
    return echo;
}

std::span<const LaserEcho> LaserHead::measure(std::span<Ray> rays, const CastRays& cast) {
    for (Ray& ray : rays) {
        ray.near = static_cast<float>(m_settings.nearest);
        ray.far = static_cast<float>(m_settings.farthest * 1.05);
    }
    m_hits.resize(rays.size());
    cast(rays, m_hits);
    castEdges(rays, cast);
    m_echoes.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto edge = static_cast<std::size_t>(m_edgeOf[i]);
        const bool cut = m_edgeOf[i] >= 0;
        m_echoes[i] =
            echoOf(rays[i], m_hits[i], cut ? &m_edgeHits[edge] : nullptr, cut ? &m_edgeRays[edge] : nullptr);
    }
    return m_echoes;
}

}  // namespace leitstand::simulation
