#pragma once

#include <Eigen/Core>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation::test {

/// Sum of the areas of triangles as vectors: zero for closed shapes [m2].
[[nodiscard]] Eigen::Vector3d openArea(const Mesh& mesh);
/// Volume inside: positive for closed shapes whose triangles face outwards [m3].
[[nodiscard]] double volumeOf(const Mesh& mesh);
/// Area of what has @p label [m2].
[[nodiscard]] double areaOf(const Mesh& mesh, Label label);
[[nodiscard]] double areaOf(const Mesh& mesh);
[[nodiscard]] Eigen::AlignedBox3d boundsOf(const Mesh& mesh);
/// What is inconsistent in numbers; empty: nothing.
[[nodiscard]] std::string faultOf(const Mesh& mesh);
/// An arena of one element.
[[nodiscard]] Arena arenaOf(const Element& element);

}  // namespace leitstand::simulation::test
