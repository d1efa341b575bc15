// What a robot's own navigation says, as it is drawn over the map.
#include "widgets/models/map/robots/robot_plans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "widgets/models/map/robots/robot_grid.h"

namespace leitstand {
namespace {

using testing::SizeIs;

constexpr Time Now{std::chrono::seconds(1'000)};

RobotState robot() {
    OdometrySample odometry;
    odometry.header.frame = "odom";
    odometry.childFrame = "base_link";
    RobotState robot;
    robot.odometry = latestPtr(Latest<OdometrySample>{1, {}, odometry});
    robot.framesAbove["odom"] = {"map", poseFrom({1.0, 0.0, 0.0}, 0, 0, 0)};
    return robot;
}

RobotInMap placed(double x = 0.0) {
    RobotInMap place;
    place.placed = true;
    place.baseInMap = poseFrom({x, 0, 0}, 0, 0, 0);
    place.odomInMap = Pose::Identity();
    return place;
}

LatestPtr<PathSample> path(const std::string& frame, double end, Time received = Now) {
    PathSample path{{{}, frame}, {}};
    for (const double x : {0.0, end / 2, end}) path.posesInFrame.push_back(poseFrom({x, 0, 0}, 0, 0, 0));
    return latestPtr(Latest<PathSample>{2, received, path});
}

TEST(RobotPlans, LieInTheMapAndStayAsTheyAreWhileNothingMoves) {
    RobotState state = robot();
    state.paths["/plan"] = path("map", 5.0);
    RobotPlans plans;
    const auto drawn = plans.at(state, placed(), Now);
    ASSERT_TRUE(drawn);
    ASSERT_THAT(*drawn, SizeIs(1));
    ASSERT_THAT(drawn->front(), SizeIs(3));
    EXPECT_NEAR(drawn->front().front().x(), -1.0, 1e-9);
    EXPECT_NEAR(drawn->front().back().x(), 4.0, 1e-9);
    EXPECT_EQ(plans.at(state, placed(0.2), Now), drawn) << "the robot drives along";
    RobotInMap moved = placed();
    moved.odomInMap = poseFrom({0, 0.5, 0}, 0, 0, 0);
    const auto again = plans.at(state, moved, Now);
    ASSERT_TRUE(again);
    EXPECT_NEAR(again->front().front().y(), 0.5, 1e-9) << "the map moved";
}

TEST(RobotPlans, AreOverAtTheirEndAndWhenNoneComes) {
    RobotState state = robot();
    state.paths["/plan"] = path("map", 5.0);
    RobotPlans plans;
    EXPECT_TRUE(plans.at(state, placed(3.0), Now));
    EXPECT_FALSE(plans.at(state, placed(3.8), Now)) << "it is there";
    EXPECT_TRUE(plans.at(state, placed(), Now + RobotPlans::Lasts));
    EXPECT_FALSE(plans.at(state, placed(), Now + RobotPlans::Lasts + std::chrono::seconds(1)));
    state.paths["/plan"] = path("nowhere", 5.0);
    EXPECT_FALSE(plans.at(state, placed(), Now));
    state.paths["/plan"] = latestPtr(Latest<PathSample>{3, Now, {{{}, "map"}, {}}});
    EXPECT_FALSE(plans.at(state, placed(), Now)) << "no way was found";
}

TEST(RobotGrids, AreShownOneAfterTheOtherWhereTfPutsThem) {
    RobotState state = robot();
    EXPECT_EQ(gridAfter("", state), "");
    OccupancyGridSample grid;
    grid.header.frame = "map";
    grid.gridInFrame = poseFrom({2.0, 3.0, 0.0}, 0, 0, 0);
    state.grids["/map"] = latestPtr(Latest<OccupancyGridSample>{4, Now, grid});
    grid.header.frame = "nowhere";
    state.grids["/local_costmap/costmap"] = latestPtr(Latest<OccupancyGridSample>{5, Now, grid});
    EXPECT_EQ(gridAfter("", state), "/local_costmap/costmap");
    EXPECT_EQ(gridAfter("/local_costmap/costmap", state), "/map");
    EXPECT_EQ(gridAfter("/map", state), "");
    EXPECT_FALSE(robotGridOf("/local_costmap/costmap", state, placed()));
    EXPECT_FALSE(robotGridOf("/other", state, placed()));
    const auto shown = robotGridOf("/map", state, placed());
    ASSERT_TRUE(shown);
    EXPECT_TRUE(shown->gridInMap.isApprox(poseFrom({1.0, 3.0, 0.0}, 0, 0, 0)));
    RobotGrid moved = *shown;
    moved.gridInMap.translation().x() += 0.005;
    EXPECT_TRUE(sameGrid(*shown, moved));
    moved.gridInMap.translation().x() += 0.02;
    EXPECT_FALSE(sameGrid(*shown, moved));
}

}  // namespace
}  // namespace leitstand
