#include "core/mapping/graph/graph_solver.h"

#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/mapping/graph/link_error.h"
#include "tests/core/mapping/graph/sample_graphs.h"

namespace leitstand {
namespace {

using test::floorGraph;
using test::LinkNoise;
using test::sphereGraph;
using test::trueFloorGraph;

constexpr LinkNoise Scans{0.01, 0.002};  // about what a match of two scans is good for

double farthest(const PoseGraph& graph, const PoseGraph& truth) {
    double largest = 0.0;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        largest = std::max(largest, distanceBetween(graph.nodes[i].pose, truth.nodes[i].pose));
    return largest;
}

int dismissed(const GraphResult& result) {
    return static_cast<int>(std::count_if(result.weights.begin(), result.weights.end(),
                                          [](double weight) { return weight < 0.5; }));
}

bool same(const PoseGraph& a, const PoseGraph& b) {
    return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                      [](const GraphNode& one, const GraphNode& other) {
                          return one.pose.matrix() == other.pose.matrix();
                      });
}

/// Largest component of the cost's gradient, by differences.
double steepest(const PoseGraph& graph, std::size_t node) {
    double largest = 0.0;
    for (Eigen::Index axis = 0; axis < 6; ++axis) {
        LinkVector step = LinkVector::Zero();
        step[axis] = 1e-5;
        PoseGraph ahead = graph, back = graph;
        ahead.nodes[node].pose = movedBy(graph.nodes[node].pose, step);
        back.nodes[node].pose = movedBy(graph.nodes[node].pose, -step);
        largest = std::max(largest, std::abs(costOf(ahead) - costOf(back)) / 2e-5);
    }
    return largest;
}

TEST(GraphSolver, LoopsBringAWayOfAKilometreBackToItself) {
    const PoseGraph truth = trueFloorGraph(1000, 8, 4);
    PoseGraph graph = floorGraph(1000, 8, 0, Scans, 4);
    const double before = farthest(graph, truth);
    GraphSettings settings;
    settings.costChange = 1e-12;
    const GraphResult result = solve(graph, settings);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.cost, 1e-3 * result.costBefore);
    EXPECT_GT(before, 1.0);
    EXPECT_LT(farthest(graph, truth), 0.25) << "3 parts in 10,000";
    for (const std::size_t node : {1U, 500U, 999U})
        EXPECT_LT(steepest(graph, node), 0.05) << "no way leads down";
}

TEST(GraphSolver, TheFirstNodeOfEachPartStaysAndWhatIsFixedStays) {
    PoseGraph graph = floorGraph(400, 12, 0, Scans, 2);
    for (Link& link : graph.links) link.active = (link.from <= 200) == (link.to <= 200);
    graph.nodes[340].fixed = true;
    PoseGraph solved = graph;
    (void)solve(solved);
    EXPECT_EQ(solved.nodes[0].pose.matrix(), graph.nodes[0].pose.matrix());
    EXPECT_EQ(solved.nodes[340].pose.matrix(), graph.nodes[340].pose.matrix());
    const auto moved = [&](std::size_t first, std::size_t last) {
        double largest = 0.0;
        for (std::size_t i = first; i < last; ++i)
            largest = std::max(largest, distanceBetween(solved.nodes[i].pose, graph.nodes[i].pose));
        return largest;
    };
    EXPECT_GT(moved(0, 200), 0.001);
    EXPECT_GT(moved(200, 400), 0.001);
}

TEST(GraphSolver, GivesTheSameBitsEachTime) {
    PoseGraph first = floorGraph(300, 5, 5, Scans, 3), second = first;
    GraphSettings settings;
    settings.robust = true;
    (void)solve(first, settings);
    (void)solve(second, settings);
    EXPECT_TRUE(same(first, second));
}

TEST(GraphSolver, ALinkThatIsTakenBackLeavesNothingBehind) {
    const PoseGraph graph = floorGraph(300, 5, 1, Scans, 3);
    PoseGraph without = graph, takenBack = graph;
    without.links.pop_back();
    takenBack.links.back().active = false;
    (void)solve(without);
    (void)solve(takenBack);
    EXPECT_TRUE(same(without, takenBack));
}

TEST(GraphSolver, FalseLoopsAreDismissedAndTrueOnesKept) {
    for (const std::uint64_t seed : {11U, 12U, 13U, 14U, 15U}) {
        constexpr int Wrong = 20;
        PoseGraph right = floorGraph(500, 6, 0, Scans, seed);
        (void)solve(right);
        PoseGraph graph = floorGraph(500, 6, Wrong, Scans, seed);
        GraphSettings settings;
        settings.robust = true;
        const GraphResult result = solve(graph, settings);
        EXPECT_LT(farthest(graph, right), 0.03) << "seed " << seed;
        EXPECT_LT(result.cost, 6.0 * double(graph.links.size())) << "what is dismissed costs nothing";
        const auto loops = std::count_if(graph.links.begin(), graph.links.end(),
                                         [](const Link& link) { return link.kind == LinkKind::Loop; });
        EXPECT_LE(dismissed(result), Wrong + int(double(loops) * 0.03))
            << "seed " << seed << ", of " << loops;
    }
}

TEST(GraphSolver, AnOpenDirectionIsLeftToOtherLinks) {
    // Three scans in a corridor along x: each match holds all but x, odometry all of it badly.
    PoseGraph graph;
    for (std::uint64_t id = 1; id <= 3; ++id) {
        Pose pose = Pose::Identity();
        pose.translation().x() = 1.3 * double(id - 1);
        graph.nodes.push_back({id, pose, false});
    }
    for (std::uint64_t id = 1; id <= 2; ++id) {
        Link match;
        match.from = id;
        match.to = id + 1;
        match.pose.translation() = Eigen::Vector3d(5.0, 0.01, 0.0);  // along x it knows nothing
        match.information = 1e6 * Information::Identity();
        match.information(0, 0) = 0.0;
        Link odometry = match;
        odometry.kind = LinkKind::Odometry;
        odometry.pose.translation() = Eigen::Vector3d(1.0, 0.3, 0.0);
        odometry.information = 100.0 * Information::Identity();
        graph.links.push_back(match);
        graph.links.push_back(odometry);
    }
    EXPECT_TRUE(solve(graph, {.costChange = 1e-12}).converged);
    EXPECT_NEAR(graph.nodes[2].pose.translation().x(), 2.0, 1e-6);
    EXPECT_NEAR(graph.nodes[2].pose.translation().y(), 0.02, 1e-3);
}

TEST(GraphSolver, EndsOnWhatCannotBeSolved) {
    PoseGraph empty;
    EXPECT_TRUE(solve(empty).converged);
    PoseGraph lone;
    lone.nodes.push_back({7, Pose::Identity(), false});
    EXPECT_TRUE(solve(lone).converged);
    PoseGraph open = floorGraph(10, 3, 0, Scans, 1);
    for (Link& link : open.links) link.information.setZero();
    const PoseGraph before = open;
    (void)solve(open);
    EXPECT_TRUE(same(open, before)) << "nothing holds anything";
    open.links.front().to = 999;  // a node that is not there
    (void)solve(open);
}

TEST(GraphSolver, StopsWhenItIsAskedTo) {
    PoseGraph graph = sphereGraph(2000, 40, {}, 1);
    std::stop_source source;
    source.request_stop();
    EXPECT_FALSE(solve(graph, {}, {.report = {}, .stop = source.get_token()}).converged);
}

}  // namespace
}  // namespace leitstand
