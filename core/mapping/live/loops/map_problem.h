#pragma once

#include <cstdint>
#include <vector>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/graph/pose_graph.h"
#include "core/mapping/live/live_settings.h"

namespace leitstand {

/// Where links want the key scans of a map: a copy of what that takes, to be solved on any thread.
struct MapProblem {
    PoseGraph graph;             ///< of scans that are not set aside
    std::uint64_t revision = 0;  ///< of the map that it is of
};

/// What came of it.
struct MapSolution {
    std::vector<GraphNode> nodes;             ///< by rising id
    std::vector<std::uint64_t> contradicted;  ///< ids of loop links that the others speak against
    std::uint64_t revision = 0;
};

/// The poses are a function of @p problem's links alone, bit for bit: not of where the scans stand.
[[nodiscard]] MapSolution solve(const MapProblem& problem, const Progress& progress = {});

/// Whether a scan that was at @p before and is at @p after has moved so far that it is told.
[[nodiscard]] bool isNoticed(const Pose& before, const Pose& after, const LoopSettings& settings);

}  // namespace leitstand
