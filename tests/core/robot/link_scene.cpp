#include "tests/core/robot/link_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

std::chrono::nanoseconds fromSeconds(double seconds) {
    return std::chrono::nanoseconds(std::llround(1e9 * seconds));
}

}  // namespace

RobotDescription linkedRobot(bool pong) {
    RobotDescription robot;
    robot.letter = std::string(1, 'K');
    robot.name = "kurt3d";
    robot.title = "Kurt3D";
    const auto add = [&](StreamRole role, const std::string& sensor = {}) {
        robot.streams.push_back(defaultStream(role, robot.name, sensor));
    };
    add(StreamRole::Odometry);
    add(StreamRole::Points);
    add(StreamRole::Picture, "left");
    add(StreamRole::Gas);
    add(StreamRole::Mode);
    add(StreamRole::Diagnostics);
    add(StreamRole::DriveCommand);
    if (pong) add(StreamRole::Ping), add(StreamRole::Pong);
    return robot;
}

LinkScene::LinkScene(bool pong, unsigned seed) : answers(pong), monitor(linkedRobot(pong)), m_random(seed) {
    const auto add = [&](const std::string& key, StreamRole role, const std::string& topic, double rate) {
        SceneStream& stream = streams[key];
        stream.role = role;
        stream.topic = topic;
        stream.rate = rate;
    };
    add("odom", StreamRole::Odometry, "/kurt3d/odom", 20.0);
    add("points", StreamRole::Points, "/kurt3d/points", 10.0);
    add("left", StreamRole::Picture, "/kurt3d/left/image/compressed", 5.0);
    add("co2", StreamRole::Gas, "/kurt3d/co2", 1.0);
    add("mode", StreamRole::Mode, "/kurt3d/mode", 0.0);
    add("diagnostics", StreamRole::Diagnostics, "/diagnostics", 0.0);
}

SteadyTime LinkScene::steadyNow() const {
    return SteadyTime(1000s + fromSeconds(m_now));
}

Time LinkScene::day(double t) const {
    return Time(1'700'000'000s + fromSeconds(t));
}

void LinkScene::publish(const std::string& key) {
    SceneStream& stream = streams.at(key);
    ++stream.reported;
    const bool lost = std::uniform_real_distribution<>(0.0, 1.0)(m_random) < stream.loss;
    if (lost || !radio) return;
    const double arrival = stream.lastArrival = std::max(m_now + stream.delay, stream.lastArrival);
    StreamArrival sample{1000,
                         {m_generation, static_cast<std::uint8_t>(stream.role)},
                         stream.reported,
                         day(m_now) + fromSeconds(ahead + stream.clockError),
                         day(arrival)};
    m_air.push_back({arrival, stream.topic, sample});
}

void LinkScene::restartRobot() {
    ++m_generation;
    for (auto& [key, stream] : streams) stream.reported = 0;
    m_pongSequence = 0;
}

void LinkScene::step() {
    m_now = 0.01 * ++m_steps;
    for (auto& [key, stream] : streams) {
        if (stream.rate <= 0.0 || m_now < stream.next) continue;
        stream.next = std::max(stream.next + 1.0 / stream.rate, m_now);
        if (on && !stream.silent) publish(key);
    }
    if (m_now >= m_nextPing && answers) {
        m_nextPing = m_now + 0.5;
        monitor.ping(++m_ping, day(m_now), steadyNow());
        const Time there = day(m_now + roundTrip / 2) + fromSeconds(ahead);
        if (radio && on)
            m_answers.push_back({m_now + roundTrip, {m_ping, "station", day(m_now), there, there}});
    }
    const auto arrives = [&](const auto& one) { return one.arrival <= m_now + 1e-9; };
    for (const OnTheWay& one : m_air) {
        if (arrives(one)) monitor.sample(one.topic, one.sample, steadyNow());
    }
    std::erase_if(m_air, arrives);
    for (const Answer& answer : m_answers) {
        if (!arrives(answer)) continue;
        monitor.sample("/kurt3d/pong", {60, {m_generation, 99}, ++m_pongSequence, {}, day(m_now)},
                       steadyNow());
        monitor.pong(answer.pong, day(m_now), steadyNow());
    }
    std::erase_if(m_answers, arrives);
}

void LinkScene::run(double seconds) {
    const int end = m_steps + static_cast<int>(std::lround(100.0 * seconds));
    while (m_steps < end) {
        step();
        if (m_steps % 10 != 0) continue;
        const std::string state = toString(monitor.status(steadyNow()).state);
        if (!m_states.empty() && m_states.back() == state) continue;
        m_states.push_back(state);
        m_changedAt = m_now;
    }
}

}  // namespace leitstand::test
