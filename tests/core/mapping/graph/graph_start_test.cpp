#include "core/mapping/graph/graph_start.h"

#include <gtest/gtest.h>

#include "core/mapping/graph/link_error.h"

namespace leitstand {
namespace {

Pose at(double x) {
    Pose pose = Pose::Identity();
    pose.translation().x() = x;
    return pose;
}

Link link(std::uint64_t from, std::uint64_t to, double x, LinkKind kind) {
    Link made;
    made.from = from;
    made.to = to;
    made.pose = at(x);
    made.kind = kind;
    return made;
}

TEST(GraphStart, FollowsTheSurestLinkFromAnEarlierNode) {
    PoseGraph graph;
    for (const std::uint64_t id : {1U, 2U, 3U})
        graph.nodes.push_back({id, at(100.0 * static_cast<double>(id)), false});
    graph.links = {link(1, 2, 1.5, LinkKind::Odometry), link(1, 2, 1.0, LinkKind::Match),
                   link(3, 1, -9.0, LinkKind::Loop), link(3, 2, -2.0, LinkKind::Odometry)};
    startFromLinks(graph);
    EXPECT_DOUBLE_EQ(graph.nodes[0].pose.translation().x(), 100.0) << "no link leads to the first";
    EXPECT_DOUBLE_EQ(graph.nodes[1].pose.translation().x(), 101.0);
    EXPECT_DOUBLE_EQ(graph.nodes[2].pose.translation().x(), 103.0) << "a link counts in both directions";
}

TEST(GraphStart, LeavesWhatNoActiveLinkLeadsToAndWhatIsFixed) {
    PoseGraph graph;
    graph.nodes = {{1, at(0.0), false}, {2, at(7.0), false}, {3, at(8.0), true}};
    graph.links = {link(1, 2, 1.0, LinkKind::Match), link(1, 3, 1.0, LinkKind::Match),
                   link(1, 99, 1.0, LinkKind::Match)};
    graph.links.front().active = false;
    startFromLinks(graph);
    EXPECT_DOUBLE_EQ(graph.nodes[1].pose.translation().x(), 7.0);
    EXPECT_DOUBLE_EQ(graph.nodes[2].pose.translation().x(), 8.0);
}

TEST(GraphStart, WhatLiesApartGoesAlongWithItsSurestLinkToWhatStays) {
    PoseGraph graph;
    // The third node begins a part of its own, which a later scan of it was found to join.
    graph.nodes = {{1, at(0.0), false}, {2, at(0.0), false}, {3, at(50.0), false}, {4, at(0.0), false}};
    graph.links = {link(1, 2, 1.0, LinkKind::Match), link(3, 4, 1.0, LinkKind::Match),
                   link(1, 4, 9.0, LinkKind::Session), link(4, 2, -2.0, LinkKind::Operator)};
    startFromLinks(graph);
    EXPECT_DOUBLE_EQ(graph.nodes[1].pose.translation().x(), 1.0);
    EXPECT_DOUBLE_EQ(graph.nodes[3].pose.translation().x(), 3.0) << "by the operator's link";
    EXPECT_DOUBLE_EQ(graph.nodes[2].pose.translation().x(), 2.0);
    graph.links[2].active = graph.links[3].active = false;
    graph.nodes[2].pose = at(50.0);
    startFromLinks(graph);
    EXPECT_DOUBLE_EQ(graph.nodes[2].pose.translation().x(), 50.0);
    EXPECT_DOUBLE_EQ(graph.nodes[3].pose.translation().x(), 51.0);
}

}  // namespace
}  // namespace leitstand
