#include <algorithm>
#include <set>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "tests/transport/convert/conversion.h"
#include "transport/convert/message_catalog.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

TEST(RoundTrip, EverySampleComesBackAsItWas) {
    for (const SampleCase& one : sampleCases()) {
        SCOPED_TRACE(one.type);
        const auto bytes = encoded(one);
        const auto sample = decodeCase(one, rawEvent(one, bytes));
        ASSERT_TRUE(sample) << sample.error().text;
        EXPECT_EQ(sample->index(), one.sample.index());
        EXPECT_EQ(encoded({one.type, one.role, *sample}), bytes);
    }
}

TEST(RoundTrip, BigEndianSamplesSayTheSame) {
    for (const SampleCase& one : sampleCases()) {
        SCOPED_TRACE(one.type);
        const auto bytes = encoded(one);
        const auto big = recoded(one.type, bytes, std::endian::big);
        ASSERT_TRUE(big) << big.error().text;
        EXPECT_EQ(big->size(), bytes.size());
        EXPECT_NE(*big, bytes);
        const auto sample = decodeCase(one, rawEvent(one, *big));
        ASSERT_TRUE(sample) << sample.error().text;
        EXPECT_EQ(encoded({one.type, one.role, *sample}), bytes);
    }
}

TEST(RoundTrip, EveryTypeIsInTheCatalogAndHasASample) {
    for (const SampleCase& one : sampleCases()) {
        EXPECT_NE(findMessageType(one.type), nullptr) << one.type;
        // The poorer of two for gas, videos and clouds.
        const std::set<std::string_view> poorer = {
            "std_msgs/msg/Float32", "foxglove_msgs/msg/CompressedVideo", "livox_ros_driver2/msg/CustomMsg"};
        // Readings come from messages of any type.
        if (poorer.contains(one.type) || one.role == StreamRole::Reading) continue;
        EXPECT_EQ(typeOf(one.sample), one.type);
    }
    for (const MessageType& type : messageTypes()) {
        const auto empty = recoded(type.rosName, {}, std::endian::little);
        EXPECT_THAT(empty.error().text, HasSubstr("encapsulation")) << type.rosName;
    }
}

TEST(RoundTrip, EveryTypeOfTheTableOfStreamsIsTried) {
    // Read as another kind of gas, or as markers: tried in tests of their own.
    const std::set<std::string_view> poorer = {
        "std_msgs/msg/Float64", "visualization_msgs/msg/Marker", "geometry_msgs/msg/PolygonStamped",
        "geometry_msgs/msg/PoseWithCovarianceStamped", "vision_msgs/msg/Detection3DArray"};
    for (const StreamFacts& row : streamTable()) {
        for (const std::string_view type : row.types) {
            if (poorer.contains(type)) continue;
            const auto cases = sampleCases();
            EXPECT_TRUE(std::any_of(cases.begin(), cases.end(),
                                    [&](const SampleCase& one) { return one.type == type; }))
                << toString(row.role) << ": tests/support/samples.cpp has no " << type;
        }
    }
}

TEST(RoundTrip, PicturesAreNotCopied) {
    for (const SampleCase& one : sampleCases()) {
        if (!one.sample.is<PictureSample>()) continue;
        const RawEvent event = rawEvent(one, encoded(one));
        const auto sample = decodeCase(one, event);
        ASSERT_TRUE(sample);
        const SharedBytes& content = sample->get<PictureSample>().content;
        EXPECT_GE(content.bytes.data(), event.cdr->data());
        EXPECT_LE(content.bytes.data() + content.bytes.size(), event.cdr->data() + event.cdr->size());
        EXPECT_EQ(content.owner, event.cdr);
    }
}

TEST(Encode, RefusesWhatAMessageCannotSay) {
    EXPECT_THAT(encode(NoteSample{}, "nav_msgs/msg/Odometry").error().text,
                HasSubstr("nav_msgs/msg/Odometry"));
    EXPECT_THAT(encode(NoteSample{}, "std_srvs/srv/Empty").error().text, HasSubstr("std_srvs/srv/Empty"));
    TwistSample twist;
    twist.linear.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(encode(twist, "geometry_msgs/msg/Twist").error().text, HasSubstr("linear"));
    JointSample joints;
    joints.names = {"a", "b"};
    joints.positions = {1.0};
    EXPECT_THAT(encode(joints, "sensor_msgs/msg/JointState").error().text, HasSubstr("position"));
}

TEST(Encode, CommandsAreStampedByTheClockThatTheRobotWants) {
    const Time now{std::chrono::seconds(1000)};
    const std::chrono::seconds ahead(3);
    EXPECT_EQ(commandStamp(StampSource::Robot, now, ahead), now + ahead);
    EXPECT_EQ(commandStamp(StampSource::Station, now, ahead), now);
    EXPECT_EQ(commandStamp(StampSource::Zero, now, ahead), std::nullopt);
    const auto bytes = encode(TwistSample{}, "geometry_msgs/msg/TwistStamped");
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(std::all_of((*bytes)->begin() + 4, (*bytes)->begin() + 12,
                            [](std::byte value) { return value == std::byte{0}; }));
}

}  // namespace
}  // namespace leitstand::test
