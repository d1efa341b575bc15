#include "core/station/robot_frames.h"

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mission/state/robot_state.h"

namespace leitstand {
namespace {

Pose at(double x, double yaw = 0.0) {
    return poseFrom({x, 0.0, 0.0}, 0.0, 0.0, yaw);
}

/// Its odometry is in "odom", which lies at x = 3 in its "map".
RobotState localised() {
    OdometrySample odometry;
    odometry.header.frame = "odom";
    odometry.childFrame = "base_link";
    odometry.baseInOdom = at(1.0);
    RobotState robot;
    robot.odometry = latestPtr(Latest<OdometrySample>{1, {}, odometry});
    robot.framesAbove["odom"] = {"map", at(3.0)};
    return robot;
}

RobotInMap placed() {
    RobotInMap place;
    place.placed = true;
    place.baseInMap = at(10.0);
    place.odomInMap = at(9.0);
    return place;
}

void expectAt(const std::optional<Pose>& found, double x) {
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->translation().x(), x, 1e-9);
}

TEST(RobotFrames, AreJoinedByTheRobotsTf) {
    expectAt(frameInMap("base_link", localised(), placed()), 10.0);
    expectAt(frameInMap("odom", localised(), placed()), 9.0);
    expectAt(frameInMap("map", localised(), placed()), 6.0);
    RobotState higher = localised();
    higher.framesAbove["map"] = {"earth", at(100.0)};
    expectAt(frameInMap("earth", higher, placed()), -94.0);
}

TEST(RobotFrames, WithoutThePlaceOfTheOdometryTheRobotsOwnPlaceTells) {
    RobotInMap place = placed();
    place.odomInMap.reset();
    expectAt(frameInMap("map", localised(), place), 6.0);
}

TEST(RobotFrames, AreUnknownWhereNoTfLeads) {
    EXPECT_FALSE(frameInMap("other", localised(), placed()));
    EXPECT_FALSE(frameInMap("map", localised(), RobotInMap{})) << "the robot is not in the map";
    EXPECT_FALSE(frameInMap("map", RobotState{}, placed())) << "it sent no odometry";
    RobotState ring = localised();
    ring.framesAbove["map"] = {"odom", at(0.0)};
    EXPECT_FALSE(frameInMap("other", ring, placed())) << "a ring has an end";
}

}  // namespace
}  // namespace leitstand
