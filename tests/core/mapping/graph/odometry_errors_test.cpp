#include "core/mapping/graph/odometry_errors.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/pose.h"
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

TEST(OdometryErrors, WaysAreAsLongAsHeldStepsShowThemToBe) {
    std::vector<bool> held(60, true);
    std::fill(held.begin() + 20, held.begin() + 50, false);
    PoseGraph graph = drive(1.03, held);
    correctOdometry(graph);
    EXPECT_NEAR(odometryOf(graph, 30), Step, 0.002 * Step) << "in the corridor where nothing else holds";
    startFromLinks(graph);
    EXPECT_NEAR(graph.nodes.back().pose.translation().x(), 60 * Step + 30 * 0.03 * Step, 0.02)
        << "matches are taken as they are";
}

TEST(OdometryErrors, AShortRunTellsLittle) {
    std::vector<bool> held(30, false);
    held[3] = true;
    PoseGraph graph = drive(1.03, held);
    correctOdometry(graph);
    EXPECT_GT(odometryOf(graph, 10), 1.01 * Step);
    EXPECT_LT(odometryOf(graph, 10), 1.03 * Step);
}

TEST(OdometryErrors, NothingIsKnownWhereNothingHolds) {
    PoseGraph graph = drive(1.03, std::vector<bool>(30, false));
    correctOdometry(graph);
    EXPECT_DOUBLE_EQ(odometryOf(graph, 10), 1.03 * Step);
}

TEST(OdometryErrors, ChainsOfOdometryHaveScalesOfTheirOwn) {
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
    correctOdometry(graph);
    EXPECT_NEAR(odometryOf(graph, 10), Step, 1e-3);
    EXPECT_NEAR(odometryOf(graph, 50), Step, 1e-3);
}

TEST(OdometryErrors, IsNoScaleBeyondFifteenPercent) {
    PoseGraph graph = drive(1.5, std::vector<bool>(40, true));
    correctOdometry(graph);
    EXPECT_NEAR(odometryOf(graph, 10), 0.85 * 1.5 * Step, 1e-6) << "slipping tracks";
}

/// Odometry that turns by @p turn [rad] too much in each step of @p graph.
void turnToo(PoseGraph& graph, double turn) {
    for (Link& link : graph.links) {
        if (link.kind == LinkKind::Odometry)
            link.pose.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * link.pose.linear();
    }
}

double turnOf(const PoseGraph& graph, std::size_t step) {
    const Eigen::AngleAxisd turn(graph.links[2 * step].pose.linear());
    return turn.angle() * turn.axis().z();
}

TEST(OdometryErrors, AHeadingThatDriftsWithTheWayGoesStraightWhereNothingHolds) {
    std::vector<bool> held(60, true);
    std::fill(held.begin() + 20, held.begin() + 50, false);
    PoseGraph graph = drive(1.0, held);
    turnToo(graph, degrees(0.5));  // 1 degree a metre
    correctOdometry(graph);
    EXPECT_LT(std::abs(turnOf(graph, 30)), degrees(0.05));
    const Eigen::Vector3d way = graph.links[60].pose.translation();
    EXPECT_LT(std::atan2(std::abs(way.y()), way.x()), degrees(0.3))
        << "half of the turn is taken out of the way";
}

TEST(OdometryErrors, TracksThatSlideTurnLessThanTheyTell) {
    PoseGraph graph;
    graph.nodes.push_back({1, Pose::Identity(), false});
    for (std::uint64_t id = 1; id <= 40; ++id) {
        graph.nodes.push_back({id + 1, Pose::Identity(), false});
        const bool held = id <= 30;
        const double truth = degrees(id % 8 < 4 ? 20 : -20);
        Link odometry = along(id, 0.1, LinkKind::Odometry, held ? 0.0 : 4000.0);
        Link match = along(id, 0.1, LinkKind::Match, held ? 10000.0 : 0.0);
        odometry.pose.linear() = Eigen::AngleAxisd(1.08 * truth, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        match.pose.linear() = Eigen::AngleAxisd(truth, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        graph.links.push_back(odometry);
        graph.links.push_back(match);
    }
    startFromLinks(graph);
    correctOdometry(graph);
    EXPECT_NEAR(std::abs(turnOf(graph, 35)), degrees(20), degrees(0.15));
}

TEST(OdometryErrors, LinksWeighAsTheStepsThatCanBeComparedShow) {
    std::vector<bool> held(200, true);
    std::fill(held.begin() + 100, held.end(), false);
    PoseGraph good = drive(1.0, held), bad = good;
    for (std::size_t i = 0; i < 100; ++i)  // 10 cm to and fro in 3 m
        bad.links[2 * i].pose.translation().x() += i / 6 % 2 == 0 ? 0.017 : -0.017;
    const double before = good.links[300].information(0, 0);
    correctOdometry(good);
    correctOdometry(bad);
    EXPECT_GT(good.links[300].information(0, 0), 1.5 * before);
    EXPECT_LT(bad.links[300].information(0, 0), good.links[300].information(0, 0));
    EXPECT_GE(bad.links[300].information(0, 0), 0.25 * before);
}

}  // namespace
}  // namespace leitstand
