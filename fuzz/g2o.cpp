#include <utility>

#include "core/io/graph/g2o_file.h"
#include "core/mapping/graph/graph_solver.h"
#include "fuzz/input_file.h"

/// Graphs of poses; what can be read is also solved, a little.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const fuzz::InputFile input(data, size);
    auto read = readG2o(input.path());
    fuzz::require(read.ok() || !read.error().text.empty(), "an error that tells something");
    if (!read.ok()) return 0;
    GraphSettings settings;
    settings.maxIterations = 3;
    settings.robust = size % 2 == 0;
    PoseGraph graph = std::move(read).value();
    const GraphResult result = solve(graph, settings);
    fuzz::require(result.weights.size() == graph.links.size(), "a weight of each link");
    for (const GraphNode& node : graph.nodes) fuzz::require(node.pose.matrix().allFinite(), "finite poses");
    return 0;
}
