#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand::benchmarks {

/// What Ceres came to.
struct CeresResult {
    double cost = 0.0;
    int iterations = 0;
};

/// Solves @p graph by Ceres with its best sparse backend on one thread, derivatives by its automatic
/// differentiation, as its own example of pose graphs does; the node with the lowest id stays.
[[nodiscard]] CeresResult solveByCeres(const PoseGraph& graph);

}  // namespace leitstand::benchmarks
