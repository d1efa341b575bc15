#include "core/robot/goal.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

TEST(Goal, AheadInTheMapIsAheadInTheOdometry) {
    const Pose inMap = poseFrom({3, 2, -0.4}, 0, 0, degrees(90));
    const Pose inOdom = poseFrom({-1, 5, 0}, 0, 0, degrees(-30));
    const Pose ahead = inMap * poseFrom({2, 1, 0}, 0, 0, degrees(45));
    const Pose goal = goalInOdom(inMap, inOdom, ahead);
    EXPECT_TRUE(goal.isApprox(inOdom * poseFrom({2, 1, 0}, 0, 0, degrees(45)), 1e-9));
}

TEST(Goal, ATiltedRobotSeesItNoFartherAway) {
    const Pose inMap = poseFrom({0, 0, 0}, degrees(10), degrees(-20), degrees(30));
    const Pose goal = goalInOdom(inMap, Pose::Identity(), poseFrom({4, 0, 0}, 0, 0, 0));
    EXPECT_NEAR(goal.translation().head<2>().norm(), 4.0, 1e-9);
    EXPECT_NEAR(goal.translation().z(), 0.0, 1e-9);
}

TEST(Goal, MovesWithTheMapALittleWhileTheRobotIsUnderWayAndIsWithdrawnElse) {
    const Pose goal = poseFrom({3, 2, 0}, 0, 0, 0);
    const auto by = [](double x) { return poseFrom({x, 0, 0}, 0, 0, 0); };
    EXPECT_EQ(goalMove(goal, by(0.005), false), GoalMove::Stays);
    EXPECT_EQ(goalMove(goal, by(0.3), true), GoalMove::Moves);
    EXPECT_EQ(goalMove(goal, by(0.3), false), GoalMove::Withdrawn) << "nobody goes there";
    EXPECT_EQ(goalMove(goal, by(1.2), true), GoalMove::Withdrawn) << "it may be in another room now";
    EXPECT_EQ(goalMove(goal, poseFrom({0, 0, 0}, 0, 0, degrees(90)), true), GoalMove::Withdrawn)
        << "turned about the map's origin it lies elsewhere";
}

}  // namespace
}  // namespace leitstand::test
