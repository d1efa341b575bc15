#include "tests/app/attack/rain.h"

#include <chrono>
#include <stdexcept>

#include "tests/app/robots/robot_process.h"
#include "tests/transport/screen/packets.h"

namespace leitstand::test {

using namespace std::chrono_literals;

std::vector<RecordedPacket> trafficOfARobot(std::size_t packets) {
    const TestDomain domain;
    const RobotProcess robot(domain, "kurt3d", {"--arena", "yellow", "--seed", "7"});
    NodeSettings settings;
    settings.domain = domain.number();
    settings.name = "ear";
    RecordingParticipant ear(settings, packets);
    ear.listen("/kurt3d/odom", bestEffort(), "nav_msgs/msg/Odometry");
    ear.listen("/kurt3d/points", reliable(10), "sensor_msgs/msg/PointCloud2");
    if (!waitUntil([&] { return ear.arrived() >= packets; }, 60s))
        throw std::runtime_error("only " + std::to_string(ear.arrived()) + " packets of a robot came");
    return ear.packets();
}

Rain::Rain(int domain, const std::vector<RecordedPacket>& traffic, unsigned seed)
    : m_attacker(domain), m_traffic(traffic), m_mutator(traffic, seed), m_thread([this](const auto& stop) {
          for (auto next = std::chrono::steady_clock::now(); !stop.stop_requested(); next += 10ms) {
              std::this_thread::sleep_until(next);
              for (int i = 0; i < 10; ++i) drop();
          }
      }) {}

void Rain::drop() {
    static constexpr Mutation Kinds[] = {Mutation::Anywhere, Mutation::InFields, Mutation::InPayload};
    const std::size_t turn = m_turn++;
    if (turn % 10 < 7) return m_attacker.send(m_mutator.next(Kinds[turn % 3]));
    if (turn % 10 == 7) return m_attacker.send(m_traffic[turn % m_traffic.size()].bytes);
    if (turn % 10 == 8) return m_attacker.send(Packet().submessage(0x80, 0, Bytes(60), 56).bytes());
    const int stranger = 1'000 + static_cast<int>(turn / 10 % 50);
    const auto topic = static_cast<int>(1 + turn / 500);
    m_attacker.announce(Packet(stranger).announce(20, 0).bytes());
    m_attacker.announce(Packet(stranger)
                            .announceEndpoint(static_cast<screen::EntityId>(topic) << 8 | 3, true, topic)
                            .bytes());
}

}  // namespace leitstand::test
