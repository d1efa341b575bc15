#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Settings of the solver: Levenberg-Marquardt (Madsen, Nielsen & Tingleff 2004).
struct GraphSettings {
    int maxIterations = 100;
    double costChange = 1e-6;  ///< the solver has converged when a step lowers the cost by a smaller share
    double initialDamping = 1e-4;
    /// Weighs loop links: those that contradict the others count less and less, in the end not at all
    /// (graduated non-convexity with truncated least squares: Yang, Antonante, Tzoumas & Carlone 2020).
    bool robust = false;
    /// Largest e^T Omega e of a loop link that may be right: 99 % of six degrees of freedom.
    double mostDisagreement = 16.8;
};

/// The result of a solver.
struct GraphResult {
    /// 1/2 sum of e^T Omega e over active links, before and after solving; in `cost`, each term times its
    /// weight.
    double costBefore = 0.0, cost = 0.0;
    int iterations = 0;
    bool converged = false;
    std::vector<double> weights;  ///< 0 to 1, of each link of the graph; 1 for links that are not weighed
};

/// Returns 1/2 sum of e^T Omega e over @p graph's active links; links to missing nodes do not count.
[[nodiscard]] double costOf(const PoseGraph& graph);

/// Moves the nodes of @p graph to the poses that fit its active links best. In each connected part without a
/// fixed node, the node with the lowest id stays. The result depends on nodes, links and their order alone.
/// Cancelled: the poses of the newest iteration.
GraphResult solve(PoseGraph& graph, const GraphSettings& settings = {}, const Progress& progress = {});

}  // namespace leitstand
