#include "core/perception/surroundings/robot_profile.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

TEST(RobotProfile, FollowsTheHeightOfTheRobot) {
    RobotDescription robot;
    robot.height = 0.65;
    EXPECT_DOUBLE_EQ(profileOf(robot).height, ProfileSettings{}.height) << "as Kurt3D was measured with";
    robot.height = 1.2;
    EXPECT_DOUBLE_EQ(profileOf(robot).height, 1.3);
    robot.height = 0.15;
    EXPECT_DOUBLE_EQ(profileOf(robot).height, 0.25);
}

TEST(RobotProfile, IsTheUsualOneWhereTheFileTellsNothing) {
    ProfileSettings usual;
    usual.height = 0.9;
    usual.climb = degrees(15);
    usual.step = 0.08;
    const ProfileSettings profile = profileOf(RobotDescription{}, usual);
    EXPECT_EQ(profile.height, 0.9);
    EXPECT_EQ(profile.climb, degrees(15));
    EXPECT_EQ(profile.step, 0.08);
}

TEST(RobotProfile, TakesRampsAndStepsFromTheFile) {
    RobotDescription robot;
    robot.maxClimb = degrees(35);
    robot.maxStep = 0.2;
    EXPECT_EQ(profileOf(robot).climb, degrees(35));
    EXPECT_EQ(profileOf(robot).step, 0.2);
}

}  // namespace
}  // namespace leitstand::test
