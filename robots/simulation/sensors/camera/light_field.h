#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

/// How bright it is everywhere in an arena: light of the hall, as far as walls and ceilings let it in, and of
/// the lamps, with their shadows. Kept on a grid, for six directions each (ambient cubes after McTaggart,
/// Half-Life 2, 2004), once for what stands still, so that a pixel costs no more rays.
class LightField {
public:
    explicit LightField(const Scene& scene);

    /// Where the part of the hall's light comes from that throws shadows; unit length.
    [[nodiscard]] static const Eigen::Vector3f& towardsHall();
    /// How much of that falls on a surface which nothing shades.
    [[nodiscard]] float direct(const Eigen::Vector3f& normal) const;
    /// Other light that falls on a surface there; with direct(), 1 is a white wall in a bright hall.
    [[nodiscard]] float at(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const;
    /// What is seen along a ray that leaves the arena: red, green, blue.
    [[nodiscard]] Eigen::Vector3f outside(const Eigen::Vector3f& direction) const;

private:
    using Cube = std::array<float, 6>;  ///< light from +x, -x, +y, -y, +z, -z
    struct Lamp {
        Eigen::Vector3f position;
        int element;
    };
    [[nodiscard]] Eigen::Vector3f positionOf(const Eigen::Vector3i& cell) const;
    [[nodiscard]] const Cube& cubeAt(const Eigen::Vector3i& cell) const;
    [[nodiscard]] Cube measure(const Scene& scene, const Eigen::Vector3f& position,
                               const std::vector<Lamp>& lamps) const;

    float m_cell = 0.0F;  ///< edge of a cell [m]
    Eigen::Vector3f m_from;
    Eigen::Vector3i m_cells;
    float m_hall = 1.0F;  ///< light of the hall
    std::vector<Cube> m_cubes;
};

}  // namespace leitstand::simulation
