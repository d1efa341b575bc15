#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/robot/model/robot_model.h"

namespace leitstand {

/// A surface of triangles.
struct TriangleMesh {
    static constexpr std::size_t MostTriangles = 2'000'000;

    std::vector<Eigen::Vector3f> vertices;                ///< [m]
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices, counter-clockwise seen from outside
    std::vector<PartColour> colours;                      ///< one per triangle
};

/// Returns the surface of @p shape in its own axes, in @p colour. A mesh has none here: it comes from a file.
[[nodiscard]] TriangleMesh surfaceOf(const PartShape& shape, const PartColour& colour);

/// Returns @p mesh with at most @p most triangles. Vertices in one cell of a grid become one, their mean
/// (vertex clustering, Rossignac & Borrel 1993); the cells are as small as the number of triangles allows.
[[nodiscard]] TriangleMesh reduced(TriangleMesh mesh, std::size_t most);

}  // namespace leitstand
