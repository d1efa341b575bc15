#include <algorithm>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/time.h"
#include "core/mapping/graph/graph_solver.h"
#include "tests/core/mapping/graph/sample_graphs.h"

namespace leitstand::test {
namespace {

double medianTime(const PoseGraph& graph, const GraphSettings& settings) {
    std::vector<double> took;
    for (int i = 0; i < 5; ++i) {
        PoseGraph copy = graph;
        const SteadyTime began = steadyNow();
        solve(copy, settings);
        took.push_back(secondsBetween(began, steadyNow()));
    }
    std::sort(took.begin(), took.end());
    return took[took.size() / 2];
}

// While it solves, the map is as it was: what the operator waits for after a loop.
TEST(GraphLatency, AThousandNodesAreSolvedWhileNobodyNotices) {
    GraphSettings robust;
    robust.robust = true;
    const double plain = medianTime(floorGraph(1'000, 8, 0, {0.02, 0.005}, 1), {}),
                 weighed = medianTime(floorGraph(1'000, 8, 10, {0.02, 0.005}, 1), robust);
    std::printf("1,000 nodes: %.0f ms, robust with ten false links %.0f ms\n", 1e3 * plain, 1e3 * weighed);
    EXPECT_LT(plain, 0.1);
    EXPECT_LT(weighed, 0.25);
}

}  // namespace
}  // namespace leitstand::test
