#include "tests/app/station/careless_robot.h"

#include <chrono>
#include <cmath>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/transport/dds/test_node.h"
#include "tests/transport/link/control_robot.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand::test {

using namespace std::chrono_literals;

RobotDescription carelessRobot() {
    RobotDescription robot = drivenRobot("rover");
    StreamDescription ranges = defaultStream(StreamRole::Ranges, "rover", {});
    ranges.sensor = "laser";
    robot.streams.push_back(ranges);
    robot.sensors["laser"] = {.frame = "laser"};
    robot.height = 0.5;
    return robot;
}

CarelessRobot::CarelessRobot(Node& node, const RobotDescription& robot) : m_robot(robot) {
    const auto publish = [&](StreamRole role) {
        const StreamDescription& stream = *robot.stream(role);
        return must(node.publisher({stream.topic, stream.type, stream.qos, Flow::Immediate}));
    };
    m_odometry = publish(StreamRole::Odometry);
    m_ranges = publish(StreamRole::Ranges);
    const StreamDescription commands = *robot.stream(StreamRole::DriveCommand);
    m_commands = must(node.subscribe({commands.topic, commands.type, commands.qos, Lane::Small},
                                     [this, commands](const ReceivedSample& sample) {
                                         const auto twist = decode(sample.event, commands);
                                         if (!twist) return;
                                         m_speed = twist->get<TwistSample>().linear.x();
                                     }));
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void CarelessRobot::run(const std::stop_token& stop) {
    auto next = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
        OdometrySample odometry;
        odometry.header = {std::chrono::system_clock::now(), m_robot.odomFrame};
        odometry.childFrame = m_robot.baseFrame;
        odometry.linear.x() = m_speed;
        m_x += 0.02 * m_speed;
        odometry.baseInOdom.translation().x() = m_x;
        (void)m_odometry->write(must(encode(odometry, "nav_msgs/msg/Odometry")));
        RangesSample ranges;
        ranges.header = {odometry.header.stamp, "laser"};
        ranges.angleMin = -M_PI;
        ranges.angleStep = 2.0 * M_PI / 360.0;
        ranges.rangeMin = 0.1;
        ranges.rangeMax = 20.0;
        ranges.ranges.assign(360, 4.0F);
        (void)m_ranges->write(must(encode(ranges, "sensor_msgs/msg/LaserScan")));
        next += 20ms;
        std::this_thread::sleep_until(next);
    }
}

}  // namespace leitstand::test
