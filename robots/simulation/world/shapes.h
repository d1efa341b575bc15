#pragma once

#include <Eigen/Core>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// Adds a surface for the shapes that follow. Returns its number in @p mesh.
int addSurface(Mesh& mesh, const Surface& surface);
/// Adds a box from corner @p from to corner @p to [m].
void addBox(Mesh& mesh, int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to);
/// Adds a box from corner @p from to corner @p to [m], in a frame at @p boxInMesh.
void addBox(Mesh& mesh, int surface, const Pose& boxInMesh, const Eigen::Vector3d& from,
            const Eigen::Vector3d& to);
/// Adds a closed cylinder around an axis from @p from to @p to [m], with @p sides side faces.
void addCylinder(Mesh& mesh, int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                 double radius, int sides = 16);
/// Adds a wedge [m] that rises along x, from 0 at its back edge to size z. x goes from 0 to size x; y is
/// centred.
void addWedge(Mesh& mesh, int surface, const Pose& wedgeInMesh, const Eigen::Vector3d& size);

}  // namespace leitstand::simulation
