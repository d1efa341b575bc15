// The tf tree of a robot, for the engineer who looks for what is wrong with it.
#include "core/station/frames/frame_tree.h"

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

constexpr Time Began{std::chrono::seconds(1'000)};

Event transforms(const std::vector<std::pair<std::string, std::string>>& parentsAndChildren,
                 Time received = Began, StreamRole role = StreamRole::Transforms) {
    TransformsSample sample;
    for (const auto& [parent, child] : parentsAndChildren) {
        FrameTransform one;
        one.header.frame = parent;
        one.childFrame = child;
        sample.transforms.push_back(one);
    }
    Event event;
    event.robot = "rover";
    event.topic = "/tf";
    event.role = role;
    event.received = received;
    event.sample = sample;
    return event;
}

std::vector<std::string> namesOf(const std::vector<FrameRow>& rows) {
    std::vector<std::string> names;
    for (const FrameRow& row : rows)
        names.push_back(std::string(static_cast<std::size_t>(row.depth), ' ') + row.node.frame);
    return names;
}

TEST(FrameTree, FramesStandBelowTheirParents) {
    FrameTree tree;
    tree.take(transforms({{"odom", "base"}, {"base", "lidar"}}));
    tree.take(transforms({{"base", "camera"}, {"camera", "optical"}}, Began, StreamRole::StaticTransforms));
    const auto rows = tree.rows(Began);
    EXPECT_THAT(namesOf(rows), ElementsAre("odom", " base", "  camera", "   optical", "  lidar"));
    EXPECT_TRUE(rows[0].root);
    EXPECT_TRUE(rows[2].node.fixed);
    EXPECT_FALSE(rows[4].node.fixed);
    EXPECT_TRUE(tree.connects("optical", "lidar"));
    EXPECT_TRUE(tree.connects("odom", "lidar"));
    EXPECT_FALSE(tree.connects("odom", "gps"));
}

TEST(FrameTree, TellsHowOftenAFrameComes) {
    FrameTree tree;
    for (int i = 0; i < 100; ++i) tree.take(transforms({{"odom", "base"}}, Began + i * milliseconds(20)));
    const auto rows = tree.rows(Began + milliseconds(2'000));
    EXPECT_NEAR(rows[1].node.rate, 50.0, 0.5);
    EXPECT_EQ(rows[1].node.received, Began + 99 * milliseconds(20));
    tree.take(transforms({{"odom", "base"}}, Began + std::chrono::seconds(60)));
    EXPECT_EQ(tree.rows(Began + std::chrono::seconds(60))[1].node.rate, 0.0) << "nobody knows after a pause";
}

TEST(FrameTree, TwoParentsOfAFrameAreNamedWhileBothCome) {
    FrameTree tree;
    tree.take(transforms({{"odom", "base"}}));
    tree.take(transforms({{"map", "base"}}, Began + milliseconds(20)));
    auto rows = tree.rows(Began + milliseconds(40));
    EXPECT_THAT(namesOf(rows), ElementsAre("map", " base"));
    EXPECT_EQ(rows[1].otherParent, "odom");
    rows = tree.rows(Began + std::chrono::seconds(8));
    EXPECT_EQ(rows[1].otherParent, "") << "the first one ceased";
}

TEST(FrameTree, StaticParentsStayInDispute) {
    FrameTree tree;
    tree.take(transforms({{"base", "lidar"}}, Began, StreamRole::StaticTransforms));
    tree.take(transforms({{"mast", "lidar"}, {"base", "mast"}}, Began, StreamRole::StaticTransforms));
    tree.take(transforms({{"odom", "base"}}, Began, StreamRole::StaticTransforms));
    tree.take(transforms({{"map", "base"}}, Began + std::chrono::seconds(60)));
    std::map<std::string, std::string> others;
    for (const FrameRow& row : tree.rows(Began + std::chrono::seconds(61)))
        others[row.node.frame] = row.otherParent;
    EXPECT_EQ(others["lidar"], "base") << "both were told for good";
    EXPECT_EQ(others["base"], "odom") << "one was told for good";
    EXPECT_EQ(others["mast"], "");
}

TEST(FrameTree, CirclesAreShownAndConnectNothing) {
    FrameTree tree;
    tree.take(
        transforms({{"a", "b"}, {"b", "c"}, {"c", "a"}, {"b", "leaf"}, {"self", "self"}, {"odom", "base"}}));
    const auto rows = tree.rows(Began);
    EXPECT_EQ(rows.size(), 7U) << "each frame once";
    int circles = 0;
    for (const FrameRow& row : rows) circles += row.circle ? 1 : 0;
    EXPECT_EQ(circles, 2);
    EXPECT_FALSE(tree.connects("a", "base"));
    EXPECT_FALSE(tree.connects("a", "leaf"));
}

TEST(FrameTree, IsBoundedHoweverManyFramesCome) {
    FrameTree tree;
    tree.take(transforms({{"base", "lidar"}}, Began, StreamRole::StaticTransforms));
    for (int i = 0; i < 5'000; ++i)
        tree.take(transforms({{"base", "person_" + std::to_string(i)}}, Began + i * milliseconds(1)));
    tree.take(transforms({{"base", std::string(300, 'x')}}));
    const auto rows = tree.rows(Began);
    EXPECT_EQ(rows.size(), FrameTree::MostFrames + 1) << "and their root";
    EXPECT_TRUE(tree.connects("lidar", "base")) << "what is static stays";
    EXPECT_TRUE(tree.connects("person_4999", "base"));
    EXPECT_FALSE(tree.connects("person_1", "base"));
}

TEST(FrameTree, ALongChainIsARow) {
    FrameTree tree;
    for (int i = 0; i < 2'000; ++i)
        tree.take(transforms({{"f" + std::to_string(i), "f" + std::to_string(i + 1)}}));
    EXPECT_EQ(tree.rows(Began).back().depth, 2'000);
}

}  // namespace
}  // namespace leitstand::test
