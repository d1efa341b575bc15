#include <gtest/gtest.h>

#include "core/io/robot/robot_file.h"
#include "robots/agent/self_driving_agent.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

RobotDescription shipped(const std::string& name) {
    return readRobot((sourceFolder() + "/resources/robots/") + name + ".yaml").value();
}

TEST(SelfDrivingScan, LooksAsHighAsTheRobotIsAndNeverLowerThanUsual) {
    const SelfDrivingSettings settings;
    EXPECT_DOUBLE_EQ(scanFor(shipped("kurt3d"), settings).profile.height, 0.75);
    EXPECT_DOUBLE_EQ(scanFor(shipped("crawler"), settings).profile.height, 0.75);
    RobotDescription tall = shipped("kurt3d");
    tall.height = 1.2;
    EXPECT_DOUBLE_EQ(scanFor(tall, settings).profile.height, 1.3);
}

}  // namespace
}  // namespace leitstand::test
