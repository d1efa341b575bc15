#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {

/// Brightness everywhere in an arena: light of the hall, as far as walls and ceilings let it in, and light of
/// the lamps, with their shadows. A grid stores it for six directions per cell (ambient cubes after
/// McTaggart, Half-Life 2, 2004). The grid is computed once from the scene, so that pixels need no more rays.
class LightField {
public:
    explicit LightField(const Scene& scene);

    /// Returns the direction towards the part of the hall's light that casts shadows; unit length.
    [[nodiscard]] static const Eigen::Vector3f& towardsHall();
    /// Returns how much of the light from towardsHall() reaches a surface that is not in shadow. @p normal:
    /// normal of the surface.
    [[nodiscard]] float direct(const Eigen::Vector3f& normal) const;
    /// Returns all other light that reaches a surface at @p point. Together with direct() this is about 1 for
    /// a white wall in a bright hall.
    [[nodiscard]] float at(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const;
    /// Returns the colour seen along a ray that leaves the arena: red, green, blue.
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
