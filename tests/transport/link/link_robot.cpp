#include "tests/transport/link/link_robot.h"

#include <condition_variable>
#include <mutex>

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand::test {

using namespace std::chrono_literals;

RobotDescription pingableRobot() {
    RobotDescription robot;
    robot.letter = std::string(1, 'K');
    robot.name = "kurt3d";
    robot.title = "Kurt3D";
    for (const StreamRole role :
         {StreamRole::Odometry, StreamRole::Points, StreamRole::Ping, StreamRole::Pong})
        robot.streams.push_back(defaultStream(role, robot.name, {}));
    return robot;
}

LinkRobot::LinkRobot(int domain, const RobotDescription& robot) : m_robot(robot) {
    NodeSettings settings;
    settings.domain = domain;
    settings.name = robot.name;
    m_node = must(Node::create(settings));
    const auto speaks = [&](StreamRole role, Flow flow) {
        const StreamDescription& stream = *m_robot.stream(role);
        return must(m_node->publisher({stream.topic, stream.type, stream.qos, flow}));
    };
    m_odometry = speaks(StreamRole::Odometry, Flow::Telemetry);
    m_pong = speaks(StreamRole::Pong, Flow::Immediate);
    const StreamDescription& ping = *m_robot.stream(StreamRole::Ping);
    m_ping = must(m_node->subscribe({ping.topic, ping.type, ping.qos, Lane::Small},
                                    [this](const ReceivedSample& sample) { answer(sample); }));
    m_thread = std::jthread([this](const std::stop_token& stop) { speak(stop); });
}

LinkRobot::~LinkRobot() {
    m_ping.reset();
}

Time LinkRobot::clock() const {
    return std::chrono::system_clock::now() + std::chrono::nanoseconds(m_ahead);
}

void LinkRobot::answer(const ReceivedSample& sample) {
    const Time received = clock();
    const auto decoded = decode(sample.event, *m_robot.stream(StreamRole::Ping));
    if (!decoded) return;
    const auto& ping = decoded->get<PingSample>();
    ++m_pings;
    m_lastPing = ping.number;
    if (m_garbage) static_cast<void>(m_pong->write(testPayload(23, 1)));
    if (!m_answering) return;
    const PongSample pong{ping.number, ping.station, ping.sent, received, clock()};
    static_cast<void>(m_pong->write(must(encode(pong, m_robot.stream(StreamRole::Pong)->type))));
}

void LinkRobot::speak(const std::stop_token& stop) {
    OdometrySample odometry;
    odometry.header.frame = "odom";
    odometry.childFrame = "base_link";
    const Payload cdr = must(encode(odometry, m_robot.stream(StreamRole::Odometry)->type));
    std::mutex mutex;
    std::condition_variable_any pause;
    while (!stop.stop_requested()) {
        if (m_speaking) static_cast<void>(m_odometry->write(cdr));
        std::unique_lock lock(mutex);
        pause.wait_for(lock, stop, 50ms, [] { return false; });
    }
}

}  // namespace leitstand::test
