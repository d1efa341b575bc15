// Readings in robots' files.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "tests/io/robot/robot_texts.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

std::string with(const std::string& keys) {
    return Head + "streams:\n  - {role: reading, topic: /bms, " + keys + "}\n";
}

std::string errorOf(const std::string& keys) {
    const auto robot = parseRobot(with(keys), "r.yaml");
    EXPECT_FALSE(robot.ok()) << keys;
    return robot.ok() ? std::string() : robot.error().text;
}

TEST(ReadingsInFiles, UsualTypesNeedNoMore) {
    const auto read = parseRobot(with("type: sensor_msgs/msg/RelativeHumidity"), "r.yaml");
    ASSERT_TRUE(read) << read.error().text;
    const StreamDescription& stream = read->streams.at(0);
    EXPECT_EQ(stream.role, StreamRole::Reading);
    EXPECT_EQ(stream.readings, usualReadings("sensor_msgs/msg/RelativeHumidity"));
    EXPECT_EQ(stream.readings.at(0).unit, "%");
}

TEST(ReadingsInFiles, AnyFieldOfAnyTypeIsNamedByItsPath) {
    const auto read = parseRobot(
        with("type: my_robot/msg/Cells, readings: ["
             "{field: \"cells[3].voltage\", title: Cell 4, unit: V, low: 3.3, low_act: 3, decimals: 2}, "
             "{field: heat, scale: 0.1, offset: -40, high: 45, high_act: 60}]"),
        "r.yaml");
    ASSERT_TRUE(read) << read.error().text;
    const StreamDescription& stream = read->streams.at(0);
    EXPECT_EQ(stream.type, "my_robot/msg/Cells");
    ASSERT_EQ(stream.readings.size(), 2U);
    EXPECT_EQ(stream.readings[0],
              (ReadingDescription{"cells[3].voltage", "Cell 4", "V", 1.0, 0.0, 2, {3.3, {}, 3.0, {}}}));
    EXPECT_EQ(stream.readings[1],
              (ReadingDescription{"heat", "heat", "", 0.1, -40.0, {}, {{}, 45.0, {}, 60.0}}));
}

TEST(ReadingsInFiles, MistakesAreToldWithTheirPlace) {
    EXPECT_THAT(errorOf("type: std_msgs/msg/Float32"),
                HasSubstr("r.yaml:4: streams[0].readings: expected a list of numbers in messages of type "
                          "std_msgs/msg/Float32, found nothing"));
    EXPECT_THAT(errorOf("type: Float32, readings: [{field: data}]"), HasSubstr("streams[0].type: expected"));
    EXPECT_THAT(errorOf("readings: []"), HasSubstr("streams[0].readings: expected 1 to 16 numbers, found 0"));
    EXPECT_THAT(errorOf("readings: [{title: Air}]"),
                HasSubstr("readings[0].field: expected the path of a number in the message, such as"));
    for (const char* path : {"\"a b\"", "a..b", "\"a[]\"", "\"a[x]\"", "\"[1]\"", "a.", "\"a[1]b\"", "1a",
                             "\"a[12345678901234567890]\""})
        EXPECT_THAT(errorOf("readings: [{field: " + std::string(path) + "}]"),
                    HasSubstr("readings[0].field: expected the path of a number"))
            << path;
    EXPECT_THAT(errorOf("readings: [{field: temperature, scale: 0}]"),
                HasSubstr("readings[0].scale: expected another number than 0"));
    EXPECT_THAT(errorOf("readings: [{field: temperature, high: .nan}]"),
                HasSubstr("readings[0].high: expected"));
    EXPECT_THAT(errorOf("readings: [{field: temperature, high: 50, high_act: 40}]"),
                HasSubstr("readings[0].high_act: expected at least 50 (that of high), found \"40\""));
    EXPECT_THAT(errorOf("readings: [{field: temperature, title: A}, {field: variance, title: A}]"),
                HasSubstr("readings[1].title: expected another title for each number, found \"A\" again"));
    EXPECT_THAT(errorOf("readings: [{field: temperature, hihg: 3}]"), HasSubstr("hihg"));
    const auto elsewhere = parseRobot(Head + "streams: [{role: imu, readings: [{field: a}]}]\n", "r.yaml");
    ASSERT_FALSE(elsewhere.ok());
    EXPECT_THAT(elsewhere.error().text, HasSubstr("expected it only for reading, found it for imu"));
}

}  // namespace
}  // namespace leitstand::test
