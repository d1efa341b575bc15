#include "tests/simulation/mapping/near_surfaces.h"

#include <algorithm>
#include <cmath>

#include "tests/simulation/mapping/nearest_on_triangle.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Cell = 0.5;  ///< edge [m]

Eigen::Vector3i cellOf(const Eigen::Vector3d& point) {
    return (point / Cell).array().floor().cast<int>();
}

std::uint64_t keyOf(const Eigen::Vector3i& cell) {
    constexpr int Offset = 1 << 20;
    const auto part = [&](int axis) { return static_cast<std::uint64_t>(cell[axis] + Offset); };
    return part(0) << 42U | part(1) << 21U | part(2);
}

}  // namespace

NearSurfaces::NearSurfaces(const Arena& arena) {
    const ArenaMesh mesh = meshOf(arena);
    add(mesh.still, Pose::Identity());
    for (const MovingPart& part : mesh.moving) {
        constexpr int Phases = 12;
        for (int i = 0; i < Phases; ++i) add(part.mesh, part.at(part.period * i / Phases));
    }
}

void NearSurfaces::add(const Mesh& mesh, const Pose& meshInArena) {
    for (const auto& corners : mesh.triangles) {
        const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
            return meshInArena * mesh.corners[corners[i]].cast<double>();
        };
        const Triangle triangle{corner(0), corner(1), corner(2)};
        const Eigen::Vector3d reach = Eigen::Vector3d::Constant(Farthest);
        const Eigen::Vector3i low = cellOf(triangle.a.cwiseMin(triangle.b).cwiseMin(triangle.c) - reach);
        const Eigen::Vector3i high = cellOf(triangle.a.cwiseMax(triangle.b).cwiseMax(triangle.c) + reach);
        const auto index = static_cast<std::uint32_t>(m_triangles.size());
        for (int x = low.x(); x <= high.x(); ++x) {
            for (int y = low.y(); y <= high.y(); ++y) {
                for (int z = low.z(); z <= high.z(); ++z) m_cells[keyOf({x, y, z})].push_back(index);
            }
        }
        m_triangles.push_back(triangle);
    }
}

double NearSurfaces::distance(const Eigen::Vector3d& point) const {
    const auto cell = m_cells.find(keyOf(cellOf(point)));
    double nearest = Farthest;
    if (cell == m_cells.end()) return nearest;
    for (const std::uint32_t index : cell->second) {
        const Triangle& of = m_triangles[index];
        nearest = std::min(nearest, (nearestOf(of.a, of.b, of.c, point) - point).norm());
    }
    return nearest;
}

}  // namespace leitstand::simulation::test
