#include "core/robot/model/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

namespace leitstand {
namespace {

constexpr std::uint32_t Sides = 24;  ///< of cylinders and spheres

void addTriangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                 const PartColour& colour) {
    mesh.triangles.push_back({a, b, c});
    mesh.colours.push_back(colour);
}

/// Adds the surface between ring @p from and the next one; both have Sides vertices, one after the other.
void addBand(TriangleMesh& mesh, std::uint32_t from, const PartColour& colour) {
    for (std::uint32_t i = 0; i < Sides; ++i) {
        const std::uint32_t a = from + i, b = from + (i + 1) % Sides;
        addTriangle(mesh, a, b, b + Sides, colour);
        addTriangle(mesh, a, b + Sides, a + Sides, colour);
    }
}

void addRing(TriangleMesh& mesh, double radius, double z) {
    for (std::uint32_t i = 0; i < Sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / Sides;
        mesh.vertices.emplace_back(
            Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z).cast<float>());
    }
}

/// Closes the ring at @p ring with a vertex at @p z.
void addCap(TriangleMesh& mesh, std::uint32_t ring, double z, bool above, const PartColour& colour) {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0F, 0.0F, static_cast<float>(z));
    for (std::uint32_t i = 0; i < Sides; ++i) {
        const std::uint32_t a = ring + i, b = ring + (i + 1) % Sides;
        addTriangle(mesh, above ? a : b, above ? b : a, middle, colour);
    }
}

TriangleMesh meshOf(const BoxShape& box, const PartColour& colour) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                   (corner & 4) != 0 ? 1 : -1);
        mesh.vertices.emplace_back((0.5 * sign.cwiseProduct(box.size)).cast<float>());
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> Faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& face : Faces) {
        addTriangle(mesh, face[0], face[1], face[2], colour);
        addTriangle(mesh, face[0], face[2], face[3], colour);
    }
    return mesh;
}

TriangleMesh meshOf(const CylinderShape& cylinder, const PartColour& colour) {
    TriangleMesh mesh;
    const double half = 0.5 * cylinder.length;
    addRing(mesh, cylinder.radius, -half);
    addRing(mesh, cylinder.radius, half);
    addBand(mesh, 0, colour);
    addCap(mesh, 0, -half, false, colour);
    addCap(mesh, Sides, half, true, colour);
    return mesh;
}

TriangleMesh meshOf(const SphereShape& sphere, const PartColour& colour) {
    constexpr std::uint32_t Rings = Sides / 2 - 1;
    TriangleMesh mesh;
    for (std::uint32_t ring = 1; ring <= Rings; ++ring) {
        const double angle = std::numbers::pi * (static_cast<double>(ring) / (Rings + 1) - 0.5);
        addRing(mesh, sphere.radius * std::cos(angle), sphere.radius * std::sin(angle));
    }
    for (std::uint32_t ring = 0; ring + 1 < Rings; ++ring) addBand(mesh, ring * Sides, colour);
    addCap(mesh, 0, -sphere.radius, false, colour);
    addCap(mesh, (Rings - 1) * Sides, sphere.radius, true, colour);
    return mesh;
}

TriangleMesh meshOf(const MeshShape&, const PartColour&) {
    return {};
}

/// Returns @p mesh with the vertices of each cell joined. The grid begins at @p least; @p edge of a cell [m].
TriangleMesh joined(const TriangleMesh& mesh, const Eigen::Vector3f& least, float edge) {
    struct Cell {
        std::uint32_t index;
        float count;
    };
    const auto hash = [](const Eigen::Vector3i& at) {
        return static_cast<std::size_t>(at.x()) * 73'856'093U ^
               static_cast<std::size_t>(at.y()) * 19'349'663U ^
               static_cast<std::size_t>(at.z()) * 83'492'791U;
    };
    std::unordered_map<Eigen::Vector3i, Cell, decltype(hash)> cells(1024, hash);
    TriangleMesh result;
    std::vector<std::uint32_t> cellOf;
    cellOf.reserve(mesh.vertices.size());
    for (const Eigen::Vector3f& vertex : mesh.vertices) {
        const Eigen::Vector3i at = ((vertex - least) / edge).array().floor().cast<int>();
        const auto [found, isNew] =
            cells.try_emplace(at, Cell{static_cast<std::uint32_t>(result.vertices.size()), 0.0F});
        if (isNew) result.vertices.emplace_back(Eigen::Vector3f::Zero());
        Cell& cell = found->second;
        cell.count += 1.0F;
        result.vertices[cell.index] += (vertex - result.vertices[cell.index]) / cell.count;
        cellOf.push_back(cell.index);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        if (cellOf[a] == cellOf[b] || cellOf[b] == cellOf[c] || cellOf[c] == cellOf[a]) continue;
        addTriangle(result, cellOf[a], cellOf[b], cellOf[c], mesh.colours[i]);
    }
    return result;
}

}  // namespace

TriangleMesh surfaceOf(const PartShape& shape, const PartColour& colour) {
    return std::visit([&](const auto& one) { return meshOf(one, colour); }, shape);
}

TriangleMesh reduced(TriangleMesh mesh, std::size_t most) {
    if (mesh.triangles.size() <= most) return mesh;
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex);
    constexpr float Coarser = 1.5F;
    // With so few cells along the diagonal even a closed surface has hardly more triangles than allowed.
    constexpr float Least = 1e-6F;  // [m]
    float edge = std::max(box.diagonal().norm() / (2.0F * std::sqrt(static_cast<float>(most) + 1.0F)), Least);
    TriangleMesh smaller = joined(mesh, box.min(), edge);
    while (smaller.triangles.size() > most) {
        edge *= Coarser;
        smaller = joined(mesh, box.min(), edge);
    }
    return smaller;
}

}  // namespace leitstand
