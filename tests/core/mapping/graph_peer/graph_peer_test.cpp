// Our solver beside Ceres, from the same start.
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "benchmarks/ceres_graph.h"
#include "core/mapping/graph/graph_solver.h"
#include "tests/core/mapping/graph/sample_graphs.h"

namespace leitstand {
namespace {

constexpr double Most = 1.005;  ///< of the cost that Ceres comes to

void compare(const PoseGraph& graph, const std::string& name) {
    PoseGraph ours = graph;
    const GraphResult result = solve(ours);
    const benchmarks::CeresResult theirs = benchmarks::solveByCeres(graph);
    EXPECT_TRUE(result.converged) << name;
    EXPECT_LE(result.cost, Most * theirs.cost) << name;
    std::printf("%s: cost %.6g in %d iterations, Ceres %.6g in %d\n", name.c_str(), result.cost,
                result.iterations, theirs.cost, theirs.iterations);
}

TEST(GraphPeer, ASphereCostsNoMoreThanCeresMakesOfIt) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) compare(test::sphereGraph(1'000, 25, {}, seed), "sphere");
}

TEST(GraphPeer, NorDoesAVeryNoisyOne) {
    compare(test::sphereGraph(1'000, 25, {.translation = 0.1, .rotation = 0.1}, 1), "noisy sphere");
}

TEST(GraphPeer, NorDoBuildings) {
    for (const std::uint64_t seed : {1U, 2U, 3U})
        compare(test::floorGraph(2'000, 12, 0, {0.02, 0.005}, seed), "building");
}

TEST(GraphPeer, OneDirectionMayBeHeldAHundredTimesWorseThanTheOthers) {
    PoseGraph graph = test::floorGraph(1'000, 8, 0, {0.02, 0.005}, 4);
    for (Link& link : graph.links) {
        link.information.row(0) *= 0.1;
        link.information.col(0) *= 0.1;
    }
    compare(graph, "corridors");
}

}  // namespace
}  // namespace leitstand
