#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation::test {

/// All surfaces of an arena as large as a building, for points that are near to one; what moves is at every
/// place that it gets to.
class NearSurfaces {
public:
    static constexpr double Farthest = 0.5;  ///< [m]

    explicit NearSurfaces(const Arena& arena);

    /// Distance of @p point from the nearest surface, arena's frame [m]; Farthest where that is farther.
    [[nodiscard]] double distance(const Eigen::Vector3d& point) const;

private:
    struct Triangle {
        Eigen::Vector3d a, b, c;
    };
    void add(const Mesh& mesh, const Pose& meshInArena);

    std::vector<Triangle> m_triangles;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;  ///< what comes near to a cell
};

}  // namespace leitstand::simulation::test
