#include "core/mapping/graph/link_scale.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/graph/graph_start.h"

namespace leitstand {
namespace {

constexpr double Step = 0.5;  ///< true way from scan to scan [m]

Link along(std::uint64_t from, double way, LinkKind kind, double information) {
    Link made;
    made.from = from;
    made.to = from + 1;
    made.pose.translation().x() = way;
    made.kind = kind;
    made.information *= information;
    return made;
}

/// A straight drive whose odometry tells the way @p scale times too long. Surfaces hold the scans in
/// @p heldSteps; elsewhere the match left the scan where odometry said.
PoseGraph drive(double scale, const std::vector<bool>& heldSteps) {
    PoseGraph graph;
    graph.nodes.push_back({1, Pose::Identity(), false});
    for (std::size_t i = 0; i < heldSteps.size(); ++i) {
        const std::uint64_t from = i + 1;
        graph.nodes.push_back({from + 1, Pose::Identity(), false});
        const bool held = heldSteps[i];
        graph.links.push_back(along(from, scale * Step, LinkKind::Odometry, held ? 0.0 : 4000.0));
        graph.links.push_back(along(from, held ? Step : scale * Step, LinkKind::Match, held ? 10000.0 : 0.0));
    }
    startFromLinks(graph);
    return graph;
}

double odometryOf(const PoseGraph& graph, std::size_t step) {
    return graph.links[2 * step].pose.translation().x();
}

TEST(LinkScale, WaysAreAsLongAsHeldStepsShowThemToBe) {
    std::vector<bool> held(60, true);
    std::fill(held.begin() + 20, held.begin() + 50, false);
    PoseGraph graph = drive(1.03, held);
    scaleOdometry(graph);
    EXPECT_NEAR(odometryOf(graph, 30), Step, 0.002 * Step) << "in the corridor where nothing else holds";
    startFromLinks(graph);
    EXPECT_NEAR(graph.nodes.back().pose.translation().x(), 60 * Step + 30 * 0.03 * Step, 0.02)
        << "matches are taken as they are";
}

TEST(LinkScale, AShortRunTellsLittle) {
    std::vector<bool> held(30, false);
    held[3] = true;
    PoseGraph graph = drive(1.03, held);
    scaleOdometry(graph);
    EXPECT_GT(odometryOf(graph, 10), 1.01 * Step);
    EXPECT_LT(odometryOf(graph, 10), 1.03 * Step);
}

TEST(LinkScale, NothingIsKnownWhereNothingHolds) {
    PoseGraph graph = drive(1.03, std::vector<bool>(30, false));
    scaleOdometry(graph);
    EXPECT_DOUBLE_EQ(odometryOf(graph, 10), 1.03 * Step);
}

TEST(LinkScale, ChainsOfOdometryHaveScalesOfTheirOwn) {
    PoseGraph graph = drive(1.04, std::vector<bool>(40, true));
    const PoseGraph other = drive(0.98, std::vector<bool>(40, true));
    for (GraphNode node : other.nodes) {
        node.id += 100;
        graph.nodes.push_back(node);
    }
    for (Link link : other.links) {
        link.from += 100;
        link.to += 100;
        graph.links.push_back(link);
    }
    scaleOdometry(graph);
    EXPECT_NEAR(odometryOf(graph, 10), Step, 1e-3);
    EXPECT_NEAR(odometryOf(graph, 50), Step, 1e-3);
}

TEST(LinkScale, IsNoScaleBeyondFifteenPercent) {
    PoseGraph graph = drive(1.5, std::vector<bool>(40, true));
    scaleOdometry(graph);
    EXPECT_NEAR(odometryOf(graph, 10), 0.85 * 1.5 * Step, 1e-6) << "slipping tracks";
}

}  // namespace
}  // namespace leitstand
