#include "core/mission/score/touches.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/robot/robot_description.h"

namespace leitstand::test {
namespace {

/// Kurt3D's: 45 cm long, 33 cm wide.
const std::vector<Eigen::Vector2d> Edge = {
    {0.225, 0.165}, {-0.225, 0.165}, {-0.225, -0.165}, {0.225, -0.165}};

TEST(Touches, AVictimWithinHalfALyingBodyOfTheBumpersSide) {
    struct Row {
        const char* bumper;
        double x, y;  // of the victim's middle, in base_link
        bool touched;
    };
    const Row table[] = {
        {"front", 0.60, 0.0, true},          // 37 cm ahead of the edge
        {"front", 0.72, 0.0, true},          // 49.5 cm
        {"front", 0.74, 0.0, false},         // 51.5 cm
        {"front", 0.0, 0.55, false},         // beside it: the front touched something else
        {"front", -0.60, 0.0, false},        // behind it
        {"rear", -0.60, 0.0, true},          //
        {"back", -0.60, 0.0, true},          //
        {"rear", 0.60, 0.0, false},          //
        {"left", 0.0, 0.60, true},           // 43.5 cm
        {"left", 0.0, -0.60, false},         //
        {"right", 0.0, -0.60, true},         //
        {"front_left", 0.45, 0.45, true},    // 36 cm from that corner
        {"front_left", 0.45, -0.45, false},  // at the other corner
        {"front_left", 0.60, -0.02, true},   // it lies across the way
        {"front_right", 0.60, 0.02, true},   //
        {"bumper 1", -0.60, 0.0, true},      // nobody knows which side: all about
        {"bumper 1", -0.74, 0.0, false},     //
        {"front", 0.1, 0.0, true},           // under it
    };
    for (const Row& row : table) {
        EXPECT_EQ(touches(Pose::Identity(), Edge, row.bumper, {row.x, row.y, 0.2}), row.touched)
            << row.bumper << " at " << row.x << ", " << row.y;
    }
}

TEST(Touches, TurnWithTheRobot) {
    const Pose standing = poseFrom({3.0, 1.0, 0.0}, 0, 0, degrees(90));
    EXPECT_TRUE(touches(standing, Edge, "front", {3.0, 1.6, 0.2}));
    EXPECT_FALSE(touches(standing, Edge, "front", {3.6, 1.0, 0.2}));
}

TEST(Touches, ARobotOfWhichNobodyKnowsTheEdgeIsRoundAndSmall) {
    EXPECT_TRUE(touches(Pose::Identity(), {}, "front", {-0.65, 0.0, 0.2}));
    EXPECT_FALSE(touches(Pose::Identity(), {}, "front", {0.75, 0.0, 0.2}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(touches(Pose::Identity(), {}, "front", {nan, 0.0, 0.2}));
    EXPECT_FALSE(touches(Pose::Identity(), Edge, "front", {nan, nan, nan}));
    RobotDescription robot;
    robot.name = "kurt3d";
    robot.footprint = Edge;
    EXPECT_EQ(footprintsOf(std::vector{robot}).at("kurt3d"), Edge);
}

}  // namespace
}  // namespace leitstand::test
