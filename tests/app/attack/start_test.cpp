#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "tests/app/robots/starts.h"
#include "tests/support/attack.h"
#include "tests/transport/screen/packets.h"
#include "tests/transport/screen_wire/mutations.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// What a robot and who listens to it say to each other in a domain of their own.
std::vector<RecordedPacket> trafficOfARobot(std::size_t packets) {
    const TestDomain domain;
    const RobotProcess robot(domain, "kurt3d", {"--arena", "yellow", "--seed", "7"});
    NodeSettings settings;
    settings.domain = domain.number();
    settings.name = "ear";
    RecordingParticipant ear(settings, packets);
    ear.listen("/kurt3d/odom", bestEffort(), "nav_msgs/msg/Odometry");
    ear.listen("/kurt3d/points", reliable(10), "sensor_msgs/msg/PointCloud2");
    EXPECT_TRUE(waitUntil([&] { return ear.arrived() >= packets; }, 60s)) << ear.arrived();
    return ear.packets();
}

/// Datagrams of every kind that fall on a domain, a thousand a second: recorded ones as they were, mutated
/// ones, statistics at the wrong place, and participants with topics that nobody knows.
class Rain {
public:
    Rain(int domain, const std::vector<RecordedPacket>& traffic, unsigned seed)
        : m_attacker(domain),
          m_traffic(traffic),
          m_mutator(traffic, seed),
          m_thread([this](const auto& stop) {
              for (auto next = std::chrono::steady_clock::now(); !stop.stop_requested(); next += 10ms) {
                  std::this_thread::sleep_until(next);
                  for (int i = 0; i < 10; ++i) drop();
              }
          }) {}

private:
    void drop() {
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

    Attacker m_attacker;
    const std::vector<RecordedPacket>& m_traffic;
    Mutator m_mutator;
    std::size_t m_turn = 0;
    std::jthread m_thread;  ///< last: joined first
};

class StartUnderAttack : public testing::Test {
protected:
    void start(StartSettings settings) {
        const auto traffic = trafficOfARobot(3'000);
        settings.meanwhile = [&](int domain) {
            return std::make_shared<Rain>(domain, traffic, settings.seed);
        };
        const double median = Starts(settings).run();
        tellAttack("wire",
                   "starts of robot, recorder and station among 1,000 packets a second of every kind (times)",
                   static_cast<std::uint64_t>(settings.runs),
                   fmt::format("all heard, after {:.1f} s (median)", median));
    }
};
using StartUnderAttackLatency = StartUnderAttack;
using StartUnderAttackLong = StartUnderAttack;

TEST_F(StartUnderAttackLatency, FiveTimes) {
    start({.runs = 5, .seed = 11});
}
TEST_F(StartUnderAttackLong, AHundredTimes) {
    start({.runs = 100, .seed = 12});
}

}  // namespace
}  // namespace leitstand::test
