#pragma once

#include <cstdint>

#include "core/mapping/graph/pose_graph.h"

namespace leitstand::test {

/// Noise of links, and of what it is said to be.
struct LinkNoise {
    double translation = 0.05;  ///< standard deviation of each coordinate [m]
    double rotation = 0.02;     ///< ... and about each axis [rad]
};

/// A way in rings up a sphere, each node linked to the one before and to the one below (the graph "sphere" of
/// Kuemmerle et al. 2011, made by another seed); poses by the first kind of link alone.
[[nodiscard]] PoseGraph sphereGraph(int nodes, int rings, const LinkNoise& noise, std::uint64_t seed);
/// A way through a building's floor on a grid of @p side x @p side corridors, 1 m a node, linked where it
/// comes by a place again; poses by odometry alone. @p wrong of the loop links are false.
[[nodiscard]] PoseGraph floorGraph(int nodes, int side, int wrong, const LinkNoise& noise,
                                   std::uint64_t seed);
/// The same with the true poses.
[[nodiscard]] PoseGraph trueFloorGraph(int nodes, int side, std::uint64_t seed);

}  // namespace leitstand::test
