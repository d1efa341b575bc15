#pragma once

#include <cstdint>
#include <vector>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/graph/pose_graph.h"
#include "core/mapping/live/live_settings.h"

namespace leitstand {

/// The key scans of a map and their links: a copy of all that is needed to solve it, on any thread.
struct MapProblem {
    PoseGraph graph;             ///< graph of the scans that are not set aside
    std::uint64_t revision = 0;  ///< revision of the map
};

/// The solution of a MapProblem.
struct MapSolution {
    std::vector<GraphNode> nodes;             ///< by rising id
    std::vector<std::uint64_t> contradicted;  ///< ids of loop links that the other links contradict
    std::uint64_t revision = 0;
};

/// Solves @p problem. The poses depend only on its links, bit for bit, and not on the scans' present poses.
[[nodiscard]] MapSolution solve(const MapProblem& problem, const Progress& progress = {});

/// Returns whether the move of a scan from @p before to @p after is large enough to be reported.
[[nodiscard]] bool isNoticed(const Pose& before, const Pose& after, const LoopSettings& settings);

}  // namespace leitstand
