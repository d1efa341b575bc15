#include "tests/simulation/mapping/true_surfaces.h"

#include <algorithm>
#include <cmath>

namespace leitstand::simulation::test {
namespace {

constexpr double Spacing = 0.04;  ///< of samples on triangles [m]

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Eigen::Vector3d nearestOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                          const Eigen::Vector3d& p) {
    const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const Eigen::Vector3d bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    const Eigen::Vector3d cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    return a + (vb * ab + vc * ac) / (va + vb + vc);
}

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
