#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Settings of the solver: Levenberg-Marquardt (Madsen, Nielsen & Tingleff 2004).
struct GraphSettings {
    int maxIterations = 100;
    /// The solver has converged when a step lowers the cost by a smaller share than this.
    double costChange = 1e-6;
    double initialDamping = 1e-4;
    /// Whether loop links are weighted. Links that contradict the others get less and less weight, at the end
    /// none (graduated non-convexity with truncated least squares: Yang, Antonante, Tzoumas & Carlone 2020).
    bool robust = false;
    /// Largest e^T Omega e at which a loop link may be right: 99 % for six degrees of freedom.
    double mostDisagreement = 16.8;
};

/// The result of a solver.
struct GraphResult {
    /// 1/2 sum of e^T Omega e over active links, before and after solving. In `cost` each term is multiplied
    /// by its weight.
    double costBefore = 0.0, cost = 0.0;
    int iterations = 0;
    bool converged = false;
    /// Weight of each link of the graph, 0 to 1; always 1 for links that are not weighted.
    std::vector<double> weights;
};

/// Returns 1/2 sum of e^T Omega e over active links of @p graph. Links to missing nodes are ignored.
[[nodiscard]] double costOf(const PoseGraph& graph);

/// Moves the nodes of @p graph to the poses that fit its active links best. In each connected part without a
/// fixed node, the node with the lowest id stays. The result depends only on nodes, links and their order.
/// Cancelled: the poses of the last iteration.
GraphResult solve(PoseGraph& graph, const GraphSettings& settings = {}, const Progress& progress = {});

}  // namespace leitstand
