#pragma once

#include <limits>
#include <span>
#include <vector>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/ray_caster.h"

namespace leitstand::simulation {

/// How a laser measures ranges.
struct LaserSettings {
    double deviation = 0.01;          ///< noise of a range, standard deviation [m]
    double deviationOfRange = 0.002;  ///< additional standard deviation, as a share of the range
    double nearest = 0.1;             ///< there is no echo nearer than this [m]
    double farthest = 30.0;           ///< there is no echo farther than this [m]
    double divergence = 0.0044;       ///< angle from the beam's middle to its edge [rad]
    double blendLength = 1.0;  ///< two echoes nearer to each other than this become one echo between them [m]
    float leastReflectivity = 0.03F;  ///< there is no echo below this reflectivity
    /// From this reflectivity on, echoes at a right angle come even from `farthest`.
    float fullReflectivity = 0.3F;
    float intensityDeviation = 0.03F;  ///< noise of the intensity, standard deviation as a share of it
};

/// Result of one laser shot.
struct LaserEcho {
    float range = std::numeric_limits<float>::quiet_NaN();  ///< [m]; NaN: no echo
    float intensity = 0.0F;  ///< reflectivity times the cosine of incidence, 0 to 255
    bool mixed = false;      ///< whether an edge cuts the beam
};

/// Turns rays into echoes: with noise, with weak and lost echoes, and with mixed pixels where the widening
/// beam hits two surfaces. A second ray at the beam's edge is cast only where neighbours differ.
class LaserHead {
public:
    LaserHead(const LaserSettings& settings, const Noise& noise) : m_settings(settings), m_noise(noise) {}

    /// Measures along @p rays (arena's frame) and sets their near and far. Consecutive rays must be
    /// neighbours in the scan. The echoes are valid until the next call.
    [[nodiscard]] std::span<const LaserEcho> measure(std::span<Ray> rays, const CastRays& cast);
    [[nodiscard]] const LaserSettings& settings() const { return m_settings; }

private:
    [[nodiscard]] bool returns(const Hit& hit, const Ray& ray) const;
    void castEdges(std::span<const Ray> rays, const CastRays& cast);
    [[nodiscard]] LaserEcho echoOf(const Ray& ray, const Hit& hit, const Hit* edge, const Ray* edgeRay);

    LaserSettings m_settings;
    Noise m_noise;
    std::vector<Hit> m_hits;    ///< hit of the middle of each beam
    std::vector<int> m_edgeOf;  ///< index in m_edgeHits for each ray; -1: none was cast
    std::vector<Ray> m_edgeRays;
    std::vector<Hit> m_edgeHits;
    std::vector<LaserEcho> m_echoes;
};

}  // namespace leitstand::simulation
