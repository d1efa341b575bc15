#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/cloud/search/kd_tree.h"
#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation::test {

/// All surfaces of an arena, those that move at every place that they get to.
class TrueSurfaces {
public:
    explicit TrueSurfaces(const Arena& arena);

    /// Distance of @p point from the nearest surface, arena's frame [m]; at most 3 cm too much.
    [[nodiscard]] double distance(const Eigen::Vector3d& point) const;

private:
    void add(const Mesh& mesh, const Pose& meshInArena);

    struct Triangle {
        Eigen::Vector3d a, b, c;
    };
    std::vector<Triangle> m_triangles;
    std::vector<Eigen::Vector3f> m_samples;
    std::vector<std::uint32_t> m_triangleOf;  ///< of each sample
    KdTree m_tree;                            ///< over the samples
};

}  // namespace leitstand::simulation::test
