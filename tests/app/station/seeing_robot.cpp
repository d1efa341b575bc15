#include "tests/app/station/seeing_robot.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>
#include <vector>

#include "core/event/cloud_sample.h"
#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

constexpr int Rays = 360;

std::unique_ptr<Publisher> publisherOf(Node& node, const RobotDescription& robot, StreamRole role) {
    const StreamDescription* stream = robot.stream(role);
    if (stream == nullptr) return nullptr;
    return must(node.publisher({stream->topic, stream->type, stream->qos, Flow::Immediate}));
}

PictureSample pictureOf(const SampleHeader& header, unsigned content) {
    auto bytes = std::make_shared<std::vector<std::byte>>(2'000, std::byte{7});
    // As JPEG files begin; nobody decodes the rest.
    std::copy_n(std::array{std::byte{0xff}, std::byte{0xd8}, std::byte{0xff}}.begin(), 3, bytes->begin());
    for (std::size_t i = 0; i < sizeof content; ++i)
        bytes->at(100 + i) = static_cast<std::byte>(content >> (8 * i) & 0xffU);
    PictureSample picture;
    picture.header = header;
    picture.compressed = true;
    picture.encoding = "jpeg";
    picture.content = {bytes, *bytes};
    return picture;
}

}  // namespace

RobotDescription seeingRobot(bool camera, bool scanner, const std::string& name) {
    RobotDescription robot = drivenRobot(name);
    if (camera) robot.streams.push_back(defaultStream(StreamRole::Picture, name, "left"));
    if (scanner) {
        robot.streams.push_back(defaultStream(StreamRole::Ranges, name, "laser"));
        robot.sensors["laser"] = {.frame = "laser", .sensorInBase = poseFrom({0.1, 0.0, 0.2}, 0, 0, 0)};
    }
    return robot;
}

SeeingRobot::SeeingRobot(Node& node, const RobotDescription& robot)
    : m_robot(robot),
      m_drive(node, robot),
      m_camera(publisherOf(node, robot, StreamRole::Picture)),
      m_scanner(publisherOf(node, robot, StreamRole::Ranges)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

void SeeingRobot::run(const std::stop_token& stop) {
    auto next = std::chrono::steady_clock::now();
    const auto write = [](Publisher& publisher, const Sample& sample, const std::string& type) {
        static_cast<void>(publisher.write(must(encode(sample, type))));
    };
    unsigned content = 0;
    while (!stop.stop_requested()) {
        const SampleHeader header{std::chrono::system_clock::now(), "laser"};
        if (pictures == Pictures::Live) ++content;
        if (m_camera && pictures != Pictures::Off)
            write(*m_camera, pictureOf(header, content), m_robot.stream(StreamRole::Picture)->type);
        if (m_scanner && scans) {
            RangesSample turn;
            turn.header = header;
            turn.angleMin = -degrees(180);
            turn.angleStep = degrees(360.0 / Rays);
            turn.rangeMax = 10.0;
            turn.ranges.assign(Rays, 3.0F);
            write(*m_scanner, turn, m_robot.stream(StreamRole::Ranges)->type);
        }
        next += std::chrono::milliseconds(50);
        std::this_thread::sleep_until(next);
    }
}

}  // namespace leitstand::test
