// Graphs of poses, solved by us and by Ceres from the same start, each on one thread.
#include <benchmark/benchmark.h>

#include "benchmarks/ceres_graph.h"
#include "core/mapping/graph/graph_solver.h"
#include "tests/core/mapping/graph/sample_graphs.h"

namespace leitstand::benchmarks {
namespace {

const PoseGraph& sphere() {
    static const PoseGraph graph = test::sphereGraph(2'500, 50, {}, 1);
    return graph;
}
const PoseGraph& building() {
    static const PoseGraph graph = test::floorGraph(5'000, 20, 0, {0.02, 0.005}, 1);
    return graph;
}

void solveOurs(benchmark::State& state, const PoseGraph& (*graph)()) {
    GraphSettings settings;
    settings.costChange = 1e-6;  // as Ceres has it
    for (auto _ : state) {
        PoseGraph copy = graph();
        const GraphResult result = solve(copy, settings);
        state.counters["cost"] = result.cost;
    }
}

void solveCeres(benchmark::State& state, const PoseGraph& (*graph)()) {
    for (auto _ : state) state.counters["cost"] = solveByCeres(graph()).cost;
}

BENCHMARK_CAPTURE(solveOurs, sphere, sphere)->Name("graph_sphere/leitstand")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solveCeres, sphere, sphere)->Name("graph_sphere/ceres")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solveOurs, building, building)
    ->Name("graph_building/leitstand")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solveCeres, building, building)
    ->Name("graph_building/ceres")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace leitstand::benchmarks
