#include "core/mapping/live/loops/map_problem.h"

#include <cstddef>
#include <utility>

#include "core/mapping/graph/graph_solver.h"
#include "core/mapping/graph/graph_start.h"
#include "core/mapping/graph/odometry_errors.h"

namespace leitstand {

MapSolution solve(const MapProblem& problem, const Progress& progress) {
    constexpr double Outweighed = 0.5;
    PoseGraph graph = problem.graph;
    startFromLinks(graph);
    correctOdometry(graph);
    startFromLinks(graph);
    GraphSettings settings;
    settings.robust = true;
    const GraphResult result = leitstand::solve(graph, settings, progress);
    MapSolution solution;
    solution.revision = problem.revision;
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        if (graph.links[i].active && result.weights[i] < Outweighed)
            solution.contradicted.push_back(graph.links[i].id);
    }
    solution.nodes = std::move(graph.nodes);
    return solution;
}

bool isNoticed(const Pose& before, const Pose& after, const LoopSettings& settings) {
    return distanceBetween(before, after) > settings.noticed ||
           angleBetween(before, after) > settings.noticedAngle;
}

}  // namespace leitstand
