#include "robots/simulation/world/motion/feelers.h"

#include <algorithm>
#include <cmath>

#include "core/event/sample.h"

namespace leitstand::simulation {
namespace {

constexpr double Spacing = 0.03;    ///< of samples on the outline [m]
constexpr double Walkable = 0.6;    ///< normals that point up so much belong to ramps, not to walls
constexpr double OverSteps = 0.01;  ///< above the highest step that is climbed [m]
constexpr std::size_t MostObstacles = 8;

struct Sample {
    Eigen::Vector2d at;
    Eigen::Vector2d middle;  ///< where its feelers begin
};

std::vector<Sample> samplesOf(const std::vector<Eigen::Vector2d>& outline) {
    Eigen::Vector2d least = outline.front(), most = outline.front();
    for (const Eigen::Vector2d& corner : outline) {
        least = least.cwiseMin(corner);
        most = most.cwiseMax(corner);
    }
    const Eigen::Vector2d half = 0.5 * (most - least), centre = 0.5 * (least + most);
    const double spine = std::max(0.0, half.x() - half.y());
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d& a = outline[i];
        const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
        const int count = std::max(1, static_cast<int>(std::ceil((b - a).norm() / Spacing)));
        for (int k = 0; k < count; ++k) {
            const Eigen::Vector2d at = a + (b - a) * k / count;
            const double along = std::clamp(at.x() - centre.x(), -spine, spine);
            samples.push_back({at, centre + Eigen::Vector2d(along, 0.0)});
        }
    }
    return samples;
}

}  // namespace

bool isOfVictim(const Arena& arena, const Surface& surface) {
    const int element = surface.element;
    if (element < 0 || element >= static_cast<int>(arena.elements.size())) return false;
    return arena.elements[static_cast<std::size_t>(element)].kind == ElementKind::Victim &&
           surface.material != Material::Plywood && surface.material != Material::Concrete;
}

Feelers::Feelers(const BodySpec& spec) {
    if (spec.outline.size() < 3) return;
    const std::vector<Sample> samples = samplesOf(spec.outline);
    m_inside.resize(samples.size());
    const double low = std::max(spec.bumpFrom, spec.maxClimb + OverSteps), high = spec.bumpTo - 0.01;
    struct Ring {
        double height;
        bool victimsOnly;
    };
    for (const Ring& ring :
         {Ring{spec.bumpFrom, true}, Ring{low, false}, Ring{0.5 * (low + high), false}, Ring{high, false}}) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const auto& [at, middle] = samples[i];
            Feeler feeler;
            feeler.from << middle, ring.height;
            feeler.to << at, ring.height;
            feeler.inward = (middle - at).normalized();
            feeler.sample = i;
            feeler.victimsOnly = ring.victimsOnly;
            m_around.push_back(feeler);
        }
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        Feeler feeler;
        feeler.inward = (samples[i].middle - samples[i].at).normalized();
        const Eigen::Vector2d at = samples[i].at + 0.002 * feeler.inward;
        feeler.from << at, low;
        feeler.to << at, high;
        feeler.sample = i;
        m_upwards.push_back(feeler);
    }
}

void Feelers::cast(const Scene& scene, int self, const Pose& pose, const std::vector<Feeler>& feelers,
                   double beyond) {
    m_rays.resize(feelers.size());
    m_hits.resize(feelers.size());
    for (std::size_t i = 0; i < feelers.size(); ++i) {
        const Eigen::Vector3d way = feelers[i].to - feelers[i].from;
        const double length = way.norm();
        m_rays[i].origin = (pose * feelers[i].from).cast<float>();
        m_rays[i].direction = (pose.linear() * (way / length)).cast<float>();
        m_rays[i].far = static_cast<float>(length + beyond);
    }
    scene.cast(m_rays, m_hits, RayKind::Contact, self);
}

void Feelers::add(const Pose& pose, const Feeler& feeler, const Hit& hit, double depth, bool victim) {
    Obstacle obstacle;
    const Eigen::Vector2d normal = (pose.linear().transpose() * hit.normal.cast<double>()).head<2>();
    obstacle.push.at = feeler.to.head<2>();
    obstacle.push.normal = normal.norm() > 0.3 ? Eigen::Vector2d(normal.normalized()) : feeler.inward;
    obstacle.push.depth = depth * std::max(0.2, feeler.inward.dot(obstacle.push.normal));
    Eigen::Vector3d inBase;
    inBase << obstacle.push.normal, 0.0;
    obstacle.normalInArena = (pose.linear() * inBase).head<2>().normalized();
    obstacle.element = hit.surface->element;
    obstacle.body = hit.body;
    obstacle.victim = victim;
    m_inside[feeler.sample] = true;
    m_found.push_back(obstacle);
}

void Feelers::feelAround(const Scene& scene, int self, const Pose& pose) {
    cast(scene, self, pose, m_around, Beyond);
    for (std::size_t i = 0; i < m_around.size(); ++i) {
        const Hit& hit = m_hits[i];
        if (!hit.there()) continue;
        const bool victim = isOfVictim(scene.arena(), *hit.surface);
        if (!victim && (m_around[i].victimsOnly || hit.normal.z() > Walkable)) continue;
        const double depth = (m_around[i].to - m_around[i].from).norm() - static_cast<double>(hit.distance);
        if (depth > 0.0) {
            add(pose, m_around[i], hit, depth, victim);
        } else {
            m_clearance = std::min(m_clearance, -depth);
        }
    }
}

void Feelers::feelUpwards(const Scene& scene, int self, const Pose& pose) {
    cast(scene, self, pose, m_upwards, 0.0);
    for (std::size_t i = 0; i < m_upwards.size(); ++i) {
        // The sample is inside something already found; the feeler met its far side.
        if (!m_hits[i].there() || m_inside[m_upwards[i].sample]) continue;
        // Looks for the edge of what the feeler met, just above its underside.
        Feeler edge = m_upwards[i];
        edge.from.z() += static_cast<double>(m_hits[i].distance) + 0.004;
        edge.to = edge.from;
        edge.from.head<2>() += 0.1 * edge.inward;
        Ray ray;
        ray.origin = (pose * edge.from).cast<float>();
        ray.direction = (pose.linear() * (edge.to - edge.from).normalized()).cast<float>();
        ray.far = static_cast<float>((edge.to - edge.from).norm());
        const Hit side = scene.cast(ray, RayKind::Contact, self);
        add(pose, edge, side.there() ? side : m_hits[i],
            side.there() ? static_cast<double>(ray.far - side.distance) : 0.002,
            isOfVictim(scene.arena(), *m_hits[i].surface));
    }
}

void Feelers::keepDeepest() {
    std::stable_sort(m_found.begin(), m_found.end(),
                     [](const Obstacle& a, const Obstacle& b) { return a.push.depth > b.push.depth; });
    std::vector<Obstacle> kept;
    for (const Obstacle& obstacle : m_found) {
        const bool reported = std::any_of(kept.begin(), kept.end(), [&](const Obstacle& other) {
            return other.push.normal.dot(obstacle.push.normal) > 0.95 &&
                   (other.push.at - obstacle.push.at).norm() < 0.08 && other.body == obstacle.body &&
                   other.element == obstacle.element;
        });
        if (!reported) kept.push_back(obstacle);
        if (kept.size() == MostObstacles) break;
    }
    m_found = std::move(kept);
}

const std::vector<Obstacle>& Feelers::feel(const Scene& scene, int self, const Pose& pose) {
    m_found.clear();
    m_clearance = Beyond;
    std::fill(m_inside.begin(), m_inside.end(), false);
    feelAround(scene, self, pose);
    feelUpwards(scene, self, pose);
    keepDeepest();
    return m_found;
}

}  // namespace leitstand::simulation
