#pragma once

#include <limits>
#include <span>
#include <vector>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/ray_caster.h"

namespace leitstand::simulation {

/// How a laser measures ranges.
struct LaserSettings {
    double deviation = 0.01;           ///< of a range [m]
    double deviationOfRange = 0.002;   ///< additional deviation, as a share of the range
    double nearest = 0.1;              ///< no echo nearer [m]
    double farthest = 30.0;            ///< no echo beyond [m]
    double divergence = 0.0044;        ///< from the beam's middle to its edge [rad]
    double blendLength = 1.0;          ///< two echoes nearer to each other melt into one between them [m]
    float leastReflectivity = 0.03F;   ///< no echo below
    float fullReflectivity = 0.3F;     ///< from here on, echoes at a right angle come even from `farthest`
    float intensityDeviation = 0.03F;  ///< of the intensity, as a share of it
};

/// Result of one laser shot.
struct LaserEcho {
    float range = std::numeric_limits<float>::quiet_NaN();  ///< [m]; NaN: no echo
    float intensity = 0.0F;  ///< 0 to 255: reflectivity times the cosine of incidence
    bool mixed = false;      ///< an edge cuts the beam
};

/// Turns rays into echoes, with noise, weak and lost echoes, and mixed pixels where the widening beam meets
/// two surfaces. A second ray at the beam's edge is cast only where neighbours differ.
class LaserHead {
public:
    LaserHead(const LaserSettings& settings, const Noise& noise) : m_settings(settings), m_noise(noise) {}

    /// Measures along @p rays (arena's frame) and sets their near and far. Rays that follow each other must
    /// be neighbours in the scan. The echoes stay valid until the next call.
    [[nodiscard]] std::span<const LaserEcho> measure(std::span<Ray> rays, const CastRays& cast);
    [[nodiscard]] const LaserSettings& settings() const { return m_settings; }

private:
    [[nodiscard]] bool returns(const Hit& hit, const Ray& ray) const;
    void castEdges(std::span<const Ray> rays, const CastRays& cast);
    [[nodiscard]] LaserEcho echoOf(const Ray& ray, const Hit& hit, const Hit* edge, const Ray* edgeRay);

    LaserSettings m_settings;
    Noise m_noise;
    std::vector<Hit> m_hits;    ///< of the middle of each beam
    std::vector<int> m_edgeOf;  ///< index into m_edgeHits, by ray; -1: none was cast
    std::vector<Ray> m_edgeRays;
    std::vector<Hit> m_edgeHits;
    std::vector<LaserEcho> m_echoes;
};

}  // namespace leitstand::simulation
