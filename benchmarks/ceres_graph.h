#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand::benchmarks {

/// The result of Ceres.
struct CeresResult {
    double cost = 0.0;
    int iterations = 0;
};

/// Solves @p graph with Ceres, using its best sparse backend on one thread. Derivatives come from its
/// automatic differentiation, as in its own example of pose graphs. The node with the lowest id stays.
[[nodiscard]] CeresResult solveByCeres(const PoseGraph& graph);

}  // namespace leitstand::benchmarks
