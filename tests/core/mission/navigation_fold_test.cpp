// What a robot's own navigation says, in the state of a mission and its checkpoints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/fold.h"
#include "tests/core/mission/event_stream.h"

namespace leitstand {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

Event on(const std::string& topic, std::uint64_t sequence, Sample sample) {
    Event event = test::event(sequence, std::move(sample), "turtlebot4");
    event.topic = topic;
    return event;
}

/// 3 x 2 cells in the frame "map".
OccupancyGridSample smallGrid() {
    OccupancyGridSample grid;
    grid.header.frame = "map";
    grid.resolution = 0.05;
    grid.width = 3;
    grid.height = 2;
    grid.cells = {0, 0, 0, -1, -1, -1};
    return grid;
}

GridUpdateSample update(int x, int y, int width, int height, std::int8_t value) {
    GridUpdateSample update{.header = {}, .x = x, .y = y, .width = width, .height = height, .cells = {}};
    update.cells.assign(std::size_t(width) * std::size_t(height), value);
    return update;
}

OdometrySample odometry() {
    OdometrySample odometry;
    odometry.header.frame = "odom";
    odometry.childFrame = "base_link";
    return odometry;
}

TransformsSample transform(const std::string& parent, const std::string& child, double x) {
    FrameTransform one{{{}, parent}, child, Pose::Identity()};
    one.childInParent.translation().x() = x;
    return {{one}};
}

const RobotState& robotOf(const Fold& fold) {
    return *fold.state().robots.at("turtlebot4");
}

TEST(NavigationFold, UpdatesChangeTheGridOfTheirTopic) {
    Fold fold;
    fold.add(on("/map_updates", 1, update(0, 0, 1, 1, 100)));  // of a grid that was not received
    fold.add(on("/map", 2, smallGrid()));
    fold.add(on("/map_updates", 3, update(1, 0, 2, 2, 100)));
    const auto grid = robotOf(fold).grids.at("/map");
    EXPECT_THAT(grid->sample.cells, ElementsAre(0, 100, 100, -1, 100, 100));
    EXPECT_EQ(grid->sequence, 3U);
    for (const GridUpdateSample& outside :
         {update(2, 0, 2, 1, 7), update(0, 1, 1, 2, 7), update(3, 2, 1, 1, 7), update(0, 0, 4, 1, 7)})
        fold.add(on("/map_updates", fold.state().sequence + 1, outside));
    fold.add(on("/other", fold.state().sequence + 1, update(0, 0, 1, 1, 7)));
    EXPECT_THAT(robotOf(fold).grids.at("/map")->sample.cells, ElementsAre(0, 100, 100, -1, 100, 100));
}

TEST(NavigationFold, AHugeGridIsNotCopiedForEachOfItsUpdates) {
    OccupancyGridSample huge = smallGrid();
    huge.width = 3'000;
    huge.height = 2'000;
    huge.cells.assign(6'000'000, 0);
    Fold fold;
    fold.add(on("/map", 1, huge));
    fold.add(on("/map_updates", 2, update(0, 0, 1, 1, 100)));
    EXPECT_EQ(robotOf(fold).grids.at("/map")->sequence, 1U);
}

TEST(NavigationFold, ACheckpointWithoutTheGridThatItNamesIsNone) {
    Fold fold;
    fold.add(on("/map", 1, smallGrid()));
    MissionState state = fold.state();
    state.robots["turtlebot4"].edit().grids["/costmap"] = nullptr;
    EXPECT_FALSE(deserialised(serialised(state)));
    state.robots["turtlebot4"].edit().grids.erase("/costmap");
    state.robots["turtlebot4"].edit().paths["/plan"] = nullptr;
    EXPECT_FALSE(deserialised(serialised(state)));
}

TEST(NavigationFold, ASmallCheckpointDoesNotFillTheMemory) {
    OccupancyGridSample huge = smallGrid();
    huge.width = 4'000;
    huge.height = 4'000;
    huge.cells.assign(16'000'000, 0);
    Fold fold;
    fold.add(on("/map", 1, huge));
    MissionState state = fold.state();
    const auto grid = robotOf(fold).grids.at("/map");
    const auto hold = [&](int grids) {
        auto& all = state.robots["turtlebot4"].edit().grids;
        all.clear();
        for (int i = 0; i < grids; ++i) all["/map" + std::to_string(i)] = grid;
        return serialised(state);
    };
    EXPECT_TRUE(deserialised(hold(16)));
    const auto many = hold(40);
    EXPECT_LT(many.size(), 100'000U);
    EXPECT_FALSE(deserialised(many));
}

TEST(NavigationFold, OfTransformsThoseAboveTheOdometryAreKept) {
    Fold fold;
    fold.add(on("/tf", 1, transform("map", "odom", 1.0)));  // nobody knows yet that it is the odometry's
    fold.add(on("/odom", 2, odometry()));
    EXPECT_TRUE(robotOf(fold).framesAbove.empty());
    fold.add(on("/tf", 3, transform("map", "odom", 2.0)));
    fold.add(on("/tf", 4, transform("earth", "map", 3.0)));
    fold.add(on("/tf", 5, transform("odom", "base_link", 4.0)));
    fold.add(on("/tf", 6, transform("base_link", "arm", 5.0)));
    ASSERT_THAT(robotOf(fold).framesAbove, SizeIs(2));
    EXPECT_EQ(robotOf(fold).framesAbove.at("odom").parent, "map");
    EXPECT_EQ(robotOf(fold).framesAbove.at("odom").inParent.translation().x(), 2.0);
    EXPECT_EQ(robotOf(fold).framesAbove.at("map").parent, "earth");
    // A robot that names ever new frames does not fill the memory.
    std::string child = "earth";
    for (int i = 0; i < 100; ++i) {
        const std::string parent = "frame" + std::to_string(i);
        fold.add(on("/tf", fold.state().sequence + 1, transform(parent, child, 0.0)));
        child = parent;
    }
    EXPECT_THAT(robotOf(fold).framesAbove, SizeIs(RobotState::MostFramesAbove));
}

TEST(NavigationFold, CheckpointsHoldGridsPathsAndFrames) {
    Fold fold;
    OccupancyGridSample wide = smallGrid();
    wide.width = 70'000;  // longer than a run
    wide.cells.assign(140'000, 0);
    wide.cells[69'999] = 100;
    fold.add(on("/odom", 1, odometry()));
    fold.add(on("/tf", 2, transform("map", "odom", 2.0)));
    fold.add(on("/map", 3, smallGrid()));
    fold.add(on("/costmap", 4, wide));
    fold.add(on("/plan", 5, PathSample{{{}, "map"}, {Pose::Identity(), Pose::Identity()}}));
    const auto bytes = serialised(fold.state());
    EXPECT_LT(bytes.size(), 4'000U) << "cells as runs";
    const auto back = deserialised(bytes);
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(serialised(*back), bytes);
    const RobotState& robot = *back->robots.at("turtlebot4");
    EXPECT_EQ(robot.grids.at("/costmap")->sample.cells, wide.cells);
    EXPECT_EQ(robot.grids.at("/map")->sample.cells, smallGrid().cells);
    EXPECT_THAT(robot.paths.at("/plan")->sample.posesInFrame, SizeIs(2));
    EXPECT_EQ(robot.framesAbove.at("odom").parent, "map");
}

}  // namespace
}  // namespace leitstand
