#pragma once

#include "robots/simulation/arena/arena.h"
#include "robots/simulation/arena/mesh/mesh_builder.h"

namespace leitstand::simulation {

/// Looks of a person's parts.
struct PersonLooks {
    Look skin, shirt, trousers, hair, shoes;
};

/// Joints of a person of length 1, for scaling. The person lies on its back along x, head at +x, with the
/// middle of its back at the origin.
struct Joints {
    Eigen::Vector3d head{0.445, 0.0, 0.07};
    Eigen::Vector3d mouth{0.425, 0.0, 0.128};
    Eigen::Vector3d neck{0.37, 0.0, 0.06};
    Eigen::Vector3d shoulder{0.32, 0.105, 0.06};  ///< left shoulder (+y); the right one is its mirror image
    Eigen::Vector3d hip{-0.02, 0.05, 0.06};
    Eigen::Vector3d knee{-0.25, 0.07, 0.055};
    Eigen::Vector3d ankle{-0.46, 0.075, 0.035};
};

/// Adds trunk, head and legs of a person of @p length [m], in the builder's frame.
void addTrunk(MeshBuilder& builder, const PersonLooks& looks, double length);
/// Adds an arm from its shoulder (the origin), along @p upper and then along @p lower (unit vectors).
void addArm(MeshBuilder& builder, const PersonLooks& looks, const Eigen::Vector3d& upper,
            const Eigen::Vector3d& lower, double length);

}  // namespace leitstand::simulation
