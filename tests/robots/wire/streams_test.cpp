#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "robots/simulation/sensors/camera/picture_file_writing.h"
#include "tests/robots/wire/wire_station.h"

namespace leitstand::test {
namespace {

std::vector<std::byte> bytesOf(const Sample& sample, const std::string& type) {
    return *must(encode(sample, type));
}

/// A robot of a shipped file on the wire, and a station that hears it.
class WireStreams : public testing::TestWithParam<std::string> {
protected:
    const TestDomain m_domain;
    const RobotDescription m_robot = fileOf(GetParam());
    std::unique_ptr<Node> m_there = nodeIn(m_domain, {.name = "robot"}), m_here = nodeIn(m_domain);
    std::unique_ptr<RobotWire> m_wire = must(RobotWire::create(*m_there, m_robot));
};

TEST_P(WireStreams, AllComeAsTheFileSaysAndAsTheyWereSaid) {
    RobotListener station(*m_here, m_robot);
    std::size_t published = 0;
    for (const StreamDescription& stream : m_robot.streams) {
        if (isCommand(stream.role)) continue;
        const Sample sample = sampleFor(stream);
        // The first may be lost before both sides know each other.
        const std::uint64_t before = m_wire->counts().published;
        EXPECT_TRUE(waitUntil([&] {
            m_wire->publish({stream.role, stream.sensor, sample});
            return station.count(stream.topic) > 0;
        })) << stream.topic;
        published += m_wire->counts().published - before;
        EXPECT_EQ(bytesOf(station.on(stream.topic).front().sample, stream.type), bytesOf(sample, stream.type))
            << stream.topic;
    }
    EXPECT_EQ(m_wire->counts().published, published) << "each on its own stream only";
    EXPECT_EQ(m_wire->counts().unpublished, 0u);
    EXPECT_THAT(station.errors(), testing::IsEmpty());
}

TEST_P(WireStreams, TopicsTypesAndQosAreThoseOfTheFile) {
    const auto endpointOf = [&](const StreamDescription& stream) -> std::optional<RemoteEndpoint> {
        const auto kind =
            isCommand(stream.role) ? RemoteEndpoint::Kind::Reader : RemoteEndpoint::Kind::Writer;
        for (const RemoteEndpoint& one : m_here->endpoints()) {
            if (one.topic == stream.topic && one.kind == kind) return one;
        }
        return std::nullopt;
    };
    for (const StreamDescription& stream : m_robot.streams) {
        ASSERT_TRUE(waitUntil([&] { return endpointOf(stream).has_value(); })) << stream.topic;
        const RemoteEndpoint found = *endpointOf(stream);
        EXPECT_EQ(found.type, stream.type) << stream.topic;
        EXPECT_EQ(found.participantName, "robot");
        EXPECT_TRUE(found.ros) << stream.topic;
        EXPECT_EQ(found.qos.reliability, stream.qos.reliability) << stream.topic;
        EXPECT_EQ(found.qos.durability, stream.qos.durability) << stream.topic;
        // A reader's lifespan is nobody's matter but its own.
        const double lifespan = isCommand(stream.role) ? found.qos.lifespan : stream.qos.lifespan;
        EXPECT_DOUBLE_EQ(found.qos.lifespan, lifespan) << stream.topic;
    }
}

TEST_P(WireStreams, WhatTheRobotHasNoStreamForIsNotSaid) {
    m_wire->publish({StreamRole::Picture, "none", sampleFor(*m_robot.stream(StreamRole::Picture))});
    EXPECT_EQ(m_wire->counts().published + m_wire->counts().unpublished, 0u);
    m_wire->publish({StreamRole::Odometry, {}, GasSample{}});
    EXPECT_EQ(m_wire->counts().unpublished, 1u) << "no odometry message can say that";
}

INSTANTIATE_TEST_SUITE_P(Robots, WireStreams, testing::Values("kurt3d", "crawler"),
                         [](const auto& robot) { return robot.param; });

/// Kurt3D that sends its infrared and left pictures raw, too.
RobotDescription withRawPictures() {
    RobotDescription robot = fileOf("kurt3d");
    for (const char* sensor : {"ir", "left"}) {
        const bool infrared = std::string(sensor) == "ir";
        StreamDescription raw = *robot.stream(infrared ? StreamRole::Thermal : StreamRole::Picture, sensor);
        raw.topic = "/kurt3d/" + std::string(sensor) + "/image";
        raw.type = "sensor_msgs/msg/Image";
        robot.streams.push_back(raw);
    }
    return robot;
}

/// Says @p sample at 4 Hz until @p received: what is said faster than it can leave is pushed out by the next.
template <class Condition>
bool sayUntil(RobotWire& wire, const HardwareSample& sample, Condition received) {
    auto next = std::chrono::steady_clock::now();
    return waitUntil([&] {
        if (std::chrono::steady_clock::now() >= next) {
            wire.publish(sample);
            next += std::chrono::milliseconds(250);
        }
        return received();
    });
}

TEST(WirePictures, InfraredGoesOutRawWhereTheFileSaysSoWhileSomebodyListens) {
    const TestDomain domain;
    const RobotDescription robot = withRawPictures();
    const auto there = nodeIn(domain), here = nodeIn(domain);
    const auto wire = must(RobotWire::create(*there, robot));
    std::vector<std::uint16_t> pixels(160 * 120);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::uint16_t>(28'000 + i % 4'000);
    PictureSample heat;
    heat.header = {Time(std::chrono::seconds(7)), "infrared"};
    heat.compressed = true;
    heat.encoding = "png";
    heat.content = simulation::pngFile(pixels, 160, 120);

    RobotListener compressed(*here, {*robot.stream(StreamRole::Thermal, "ir")});
    ASSERT_TRUE(sayUntil(*wire, {StreamRole::Thermal, "ir", heat},
                         [&] { return compressed.count("/kurt3d/ir/image/compressed") > 0; }));
    RobotListener raw(*here, {robot.streams[robot.streams.size() - 2]});
    ASSERT_TRUE(sayUntil(*wire, {StreamRole::Thermal, "ir", heat},
                         [&] { return raw.count("/kurt3d/ir/image") > 0; }));
    EXPECT_EQ(raw.on("/kurt3d/ir/image").front().writerSequence, 1u) << "nothing while nobody listened";
    const auto picture = raw.all<PictureSample>("/kurt3d/ir/image").front();
    EXPECT_EQ(picture.encoding, "mono16");
    EXPECT_EQ(picture.width, 160);
    EXPECT_EQ(picture.height, 120);
    EXPECT_EQ(picture.header.stamp, heat.header.stamp);
    EXPECT_EQ(picture.header.frame, "infrared");
    ASSERT_EQ(picture.content.bytes.size(), pixels.size() * 2);
    EXPECT_EQ(std::memcmp(picture.content.bytes.data(), pixels.data(), pixels.size() * 2), 0);
    EXPECT_EQ(wire->counts().unpublished, 0u);
}

TEST(WirePictures, ColourGoesOutRawTooAndBrokenFilesAreNotSaid) {
    const TestDomain domain;
    const RobotDescription robot = withRawPictures();
    const auto there = nodeIn(domain), here = nodeIn(domain);
    const auto wire = must(RobotWire::create(*there, robot));
    PictureSample left;
    left.header = {Time(std::chrono::seconds(7)), "left_camera"};
    left.compressed = true;
    left.encoding = "jpeg";
    const std::vector<std::uint8_t> red(64 * 48 * 3, 40);
    left.content = simulation::jpegFile(red, 64, 48, 90);
    RobotListener raw(*here, {robot.streams.back()});
    ASSERT_TRUE(sayUntil(*wire, {StreamRole::Picture, "left", left},
                         [&] { return raw.count("/kurt3d/left/image") > 0; }));
    const auto picture = raw.all<PictureSample>("/kurt3d/left/image").front();
    EXPECT_EQ(picture.encoding, "rgb8");
    EXPECT_EQ(picture.content.bytes.size(), red.size());
    EXPECT_NEAR(std::to_integer<int>(picture.content.bytes[0]), 40, 3);
    EXPECT_EQ(wire->counts().unpublished, 0u);
    left.content.bytes = left.content.bytes.first(100);
    wire->publish({StreamRole::Picture, "left", left});
    EXPECT_GE(wire->counts().unpublished, 1u);
}

}  // namespace
}  // namespace leitstand::test
