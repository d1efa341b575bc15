#include "core/robot/readings/reading_description.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/robot/robot_description.h"

namespace leitstand::test {
namespace {

using enum ReadingLevel;

TEST(ReadingLevels, FollowTheLimitsOnBothSides) {
    const ReadingLimits limits{10.0, 40.0, 0.0, 60.0};
    EXPECT_EQ(levelOf(limits, 25.0), Normal);
    EXPECT_EQ(levelOf(limits, 40.0), Normal) << "the limit itself is allowed";
    EXPECT_EQ(levelOf(limits, 40.1), Attention);
    EXPECT_EQ(levelOf(limits, 61.0), Act);
    EXPECT_EQ(levelOf(limits, 9.0), Attention);
    EXPECT_EQ(levelOf(limits, -1.0), Act);
    EXPECT_EQ(levelOf({}, 1e9), Normal) << "nothing was asked for";
    EXPECT_EQ(levelOf({{}, {}, {}, 60.0}, 61.0), Act) << "one limit is enough";
    EXPECT_EQ(levelOf(limits, std::numeric_limits<double>::quiet_NaN(), Act), Normal);
    EXPECT_EQ(levelOf(limits, std::numeric_limits<double>::infinity()), Act);
}

TEST(ReadingLevels, ANumberAtItsLimitDoesNotComeAndGo) {
    const ReadingLimits limits{{}, 40.0, {}, 60.0};
    EXPECT_EQ(levelOf(limits, 39.5, Attention), Attention);
    EXPECT_EQ(levelOf(limits, 39.0, Attention), Normal);
    EXPECT_EQ(levelOf(limits, 59.5, Act), Act);
    EXPECT_EQ(levelOf(limits, 58.0, Act), Attention);
    EXPECT_EQ(levelOf({-10.0, {}, {}, {}}, -9.9, Attention), Attention);
    EXPECT_EQ(levelOf({-10.0, {}, {}, {}}, -9.7, Attention), Normal);
}

TEST(ReadingLevels, EndBetweenLimitsThatAreCloseTogether) {
    const ReadingLimits pressure{990.0, 1'030.0, {}, {}};
    EXPECT_EQ(levelOf(pressure, 1'031.0), Attention);
    EXPECT_EQ(levelOf(pressure, 1'028.0, Attention), Attention);
    EXPECT_EQ(levelOf(pressure, 1'010.0, Attention), Normal);
    EXPECT_EQ(levelOf(pressure, 992.0, Attention), Attention);
    const ReadingLimits cold{0.0, 50.0, {}, {}};
    EXPECT_EQ(levelOf(cold, 0.5, Attention), Attention) << "0 has a margin, too";
    EXPECT_EQ(levelOf(cold, 1.5, Attention), Normal);
}

TEST(Readings, OfOneNameAreToldApartByTheirTopics) {
    RobotDescription robot;
    for (const char* topic : {"/front", "/rear", "/air"}) {
        StreamDescription stream;
        stream.topic = topic;
        stream.readings =
            usualReadings(stream.topic == "/air" ? "sensor_msgs/msg/Temperature" : "sensor_msgs/msg/Range");
        robot.streams.push_back(stream);
    }
    distinguishReadings(robot);
    EXPECT_EQ(robot.streams[0].readings[0].title, "distance /front");
    EXPECT_EQ(robot.streams[1].readings[0].title, "distance /rear");
    EXPECT_EQ(robot.streams[2].readings[0].title, "temperature");
}

}  // namespace
}  // namespace leitstand::test
