#include "app/services/topics/message_inspector.h"

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "tests/support/samples.h"
#include "transport/convert/encode.h"
#include "transport/convert/message_catalog.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

MessageText textOf(std::string_view type) {
    auto text = MessageText::parse(std::string(type), findMessageType(type)->definition);
    if (!text) throw std::runtime_error(text.error().text);
    return std::move(text).value();
}

std::map<std::string, std::string> valuesOf(const InspectedMessage& message) {
    std::map<std::string, std::string> values;
    for (const InspectedField& field : message.fields) values[field.path] = field.value;
    return values;
}

TEST(MessageInspector, ReadsEveryTypeThatWeWrite) {
    for (const SampleCase& one : sampleCases()) {
        const auto bytes = encode(one.sample, one.type);
        if (!bytes) continue;  // that one is only received
        const auto read = inspect(textOf(one.type), **bytes);
        ASSERT_TRUE(read) << one.type << ": " << read.error().text;
        EXPECT_FALSE(read->fields.empty()) << one.type;
    }
}

TEST(MessageInspector, TellsPathsValuesAndNumbers) {
    JointSample joints;
    joints.header = {Time(std::chrono::seconds(12)), "base_link"};
    joints.names = {"left", "right"};
    joints.positions = {0.5, std::numeric_limits<double>::quiet_NaN()};
    const std::string_view type = "sensor_msgs/msg/JointState";
    const auto read = inspect(textOf(type), **encode(joints, type));
    ASSERT_TRUE(read) << read.error().text;
    auto values = valuesOf(*read);
    EXPECT_EQ(values["header.stamp.sec"], "12");
    EXPECT_EQ(values["header.frame_id"], "\"base_link\"");
    EXPECT_EQ(values["name"], "2 elements");
    EXPECT_EQ(values["name[1]"], "\"right\"");
    EXPECT_EQ(values["position"], "[0.5, nan]");
    EXPECT_EQ(values["velocity"], "[]");
    EXPECT_EQ(numberAt(*read, "position[0]"), 0.5);
    EXPECT_EQ(numberAt(*read, "header.frame_id"), std::nullopt);
    EXPECT_EQ(read->fields[0].path, "header");
    EXPECT_EQ(read->fields[1].path, "header.stamp");
    EXPECT_EQ(read->fields[2].depth, 2);
}

TEST(MessageInspector, LongArraysAreSummedUp) {
    JointSample joints;
    for (int i = 0; i < 1'200; ++i) {
        joints.names.push_back("j" + std::to_string(i));
        joints.positions.push_back(0.001 * i);
    }
    const std::string_view type = "sensor_msgs/msg/JointState";
    const auto read = inspect(textOf(type), **encode(joints, type));
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->cut) << "its names alone are more than are shown";
    EXPECT_EQ(read->fields.size(), InspectedMessage::MostFields);
    joints.names.resize(100);
    joints.positions.resize(100);
    const auto shorter = inspect(textOf(type), **encode(joints, type));
    ASSERT_TRUE(shorter);
    EXPECT_FALSE(shorter->cut);
    EXPECT_THAT(valuesOf(*shorter)["position"], HasSubstr("100 numbers: 0, 0.001, 0.002"));
    EXPECT_THAT(valuesOf(*shorter)["position"], HasSubstr("(0 to 0.099)"));
    EXPECT_EQ(numberAt(*shorter, "position[3]"), std::nullopt);
}

TEST(MessageInspector, WhatDoesNotFitIsRefusedAndHostileTextsEnd) {
    const std::string_view type = "nav_msgs/msg/Odometry";
    for (const SampleCase& one : sampleCases()) {
        const auto bytes = encode(one.sample, one.type);
        if (!bytes) continue;
        for (std::size_t size = 0; size < (*bytes)->size(); size += 1 + size / 7) {
            const std::vector<std::byte> cut((*bytes)->begin(), (*bytes)->begin() + std::ptrdiff_t(size));
            (void)inspect(textOf(one.type), cut);
        }
        if (one.type != type) (void)inspect(textOf(type), **bytes);
    }
    std::vector<std::byte> few(12, std::byte{0});
    few[1] = std::byte{1};
    const auto huge = MessageText::parse("p/msg/A", "float64[4000000000] a\n");
    ASSERT_TRUE(huge);
    EXPECT_FALSE(inspect(*huge, few));
    const auto nothing = MessageText::parse("p/msg/A", "B[4000000000] a\n===\nMSG: p/B\n");
    ASSERT_TRUE(nothing);
    EXPECT_FALSE(inspect(*nothing, few)) << "what holds nothing has one byte";
    const auto wide = MessageText::parse("p/msg/A", "wstring a\nint32 b\n");
    ASSERT_TRUE(wide);
    const auto read = inspect(*wide, few);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->cut);
    for (int i = 4; i < 8; ++i) few[std::size_t(i)] = std::byte{0xff};
    const auto many = MessageText::parse("p/msg/A", "string[] a\n");
    EXPECT_FALSE(inspect(*many, few)) << "as many as nobody has sent";
}

}  // namespace
}  // namespace leitstand::test
