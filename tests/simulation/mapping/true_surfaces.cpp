#include "tests/simulation/mapping/true_surfaces.h"

#include <algorithm>
#include <cmath>

#include "tests/simulation/mapping/nearest_on_triangle.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Spacing = 0.04;  ///< of samples on triangles [m]

}  // namespace

TrueSurfaces::TrueSurfaces(const Arena& arena) {
    const ArenaMesh mesh = meshOf(arena);
    add(mesh.still, Pose::Identity());
    for (const MovingPart& part : mesh.moving) {
        constexpr int Phases = 12;
        for (int i = 0; i < Phases; ++i) add(part.mesh, part.at(part.period * i / Phases));
    }
    m_tree = KdTree(m_samples);
}

void TrueSurfaces::add(const Mesh& mesh, const Pose& meshInArena) {
    const auto corner = [&](std::uint32_t i) -> Eigen::Vector3d {
        return meshInArena * mesh.corners[i].cast<double>();
    };
    for (const auto& corners : mesh.triangles) {
        const Triangle triangle{corner(corners[0]), corner(corners[1]), corner(corners[2])};
        const Eigen::Vector3d u = triangle.b - triangle.a, v = triangle.c - triangle.a;
        const int steps = std::max(1, static_cast<int>(std::ceil(std::max(u.norm(), v.norm()) / Spacing)));
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; i + j <= steps; ++j) {
                m_samples.push_back((triangle.a + (u * i + v * j) / steps).cast<float>());
                m_triangleOf.push_back(static_cast<std::uint32_t>(m_triangles.size()));
            }
        }
        m_triangles.push_back(triangle);
    }
}

double TrueSurfaces::distance(const Eigen::Vector3d& point) const {
    const Neighbour nearest = m_tree.nearest(point.cast<float>());
    const Triangle& of = m_triangles[m_triangleOf[static_cast<std::size_t>(nearest.index)]];
    return (nearestOf(of.a, of.b, of.c, point) - point).norm();
}

}  // namespace leitstand::simulation::test
