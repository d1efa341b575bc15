#pragma once

#include <Eigen/Core>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// A surface of its own, to be named by what follows. Returns its number in @p mesh.
int addSurface(Mesh& mesh, const Surface& surface);
/// A box from corner @p from to corner @p to [m].
void addBox(Mesh& mesh, int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to);
/// The same box, placed by @p boxInMesh.
void addBox(Mesh& mesh, int surface, const Pose& boxInMesh, const Eigen::Vector3d& from,
            const Eigen::Vector3d& to);
/// A cylinder about an axis from @p from to @p to [m], closed, of @p sides faces around.
void addCylinder(Mesh& mesh, int surface, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                 double radius, int sides = 16);
/// A wedge that rises along x from 0 at its back edge to size z: x from 0 to size x, y about the middle [m].
void addWedge(Mesh& mesh, int surface, const Pose& wedgeInMesh, const Eigen::Vector3d& size);

}  // namespace leitstand::simulation
