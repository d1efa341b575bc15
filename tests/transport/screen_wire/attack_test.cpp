#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"
#include "tests/transport/screen/packets.h"
#include "tests/transport/screen_wire/mutations.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// A robot in a process of its own that says 100 samples a second, and a station that hears it.
class Attack : public ::testing::Test {
protected:
    void SetUp() override {
        NodeSettings settings;
        settings.interfaces = {"lo"};
        m_station = nodeIn(m_domain, settings);
        m_listening = must(m_station->subscribe({"/k/odom", TestType, reliable(10)}, m_inbox.callback()));
        ASSERT_TRUE(m_inbox.waitFor(20)) << m_robot.out();
    }
    /// Whether samples come at the full rate again within 5 s.
    [[nodiscard]] bool hearsAgain() {
        return waitUntil(
            [&] {
                const std::size_t before = m_inbox.size();
                return m_inbox.waitFor(before + 40, 500ms);  // of 50
            },
            5s);
    }
    [[nodiscard]] std::uint64_t dropped() const {
        std::uint64_t packets = 0;
        for (const ScreenDrop& drop : m_station->dropped()) packets += drop.packets;
        return packets;
    }
    [[nodiscard]] screen::Prefix robotsPrefix() const {
        screen::Prefix prefix{};
        for (const RemoteParticipant& one : m_station->participants()) {
            if (one.name == "peer") std::copy_n(one.guid.bytes.begin(), 12, prefix.begin());
        }
        return prefix;
    }
    /// @p packet in the name of the robot.
    [[nodiscard]] Bytes ofTheRobot(const Packet& packet) const {
        Bytes bytes = packet.bytes();
        const screen::Prefix prefix = robotsPrefix();
        for (std::size_t i = 0; i < prefix.size(); ++i) bytes[8 + i] = std::byte{prefix[i]};
        return bytes;
    }

    /// The robot's writer of what the station hears.
    [[nodiscard]] screen::EntityId odometryWriter() const {
        screen::EntityId id = 0;
        for (const RemoteEndpoint& endpoint : m_station->endpoints()) {
            if (endpoint.kind != RemoteEndpoint::Kind::Writer || endpoint.topic != "/k/odom") continue;
            for (std::size_t i = 12; i < 16; ++i) id = id << 8 | endpoint.guid.bytes[i];
        }
        return id;
    }
    /// The robot's @p writer takes back @p entity of it.
    [[nodiscard]] Bytes end(screen::EntityId writer, screen::EntityId entity, std::int64_t number) const {
        const Bytes guid = ByteWriter().prefix(robotsPrefix()).entity(entity).bytes;
        const Bytes qos = ByteWriter()
                              .parameter(0x0070, guid)
                              .parameter(0x0071, ByteWriter(false).u32(3).bytes)
                              .parameter(1, {})
                              .bytes;
        ByteWriter content;
        content.u16(0).u16(16).entity(0).entity(writer).sequenceNumber(number).append(qos);
        return ofTheRobot(Packet().submessage(0x15, 2, content.bytes));
    }

    const TestDomain m_domain;
    const ChildProcess m_robot{
        program("dds_peer"),
        {"talk", std::to_string(m_domain.number()), "/k/odom", "interface=lo", "period=10"}};
    Inbox m_inbox;
    std::unique_ptr<Node> m_station;
    std::unique_ptr<Subscription> m_listening;
    Attacker m_attacker{m_domain.number()};
};

TEST_F(Attack, OnePacketOfStatisticsHarmsNobody) {
    for (int i = 0; i < 17; ++i) m_attacker.send(Packet().submessage(0x80, 0, Bytes(60), 56).bytes());
    for (int i = 0; i < 17; ++i) m_attacker.send(Packet(1, false).submessage(0x80, 0, Bytes(60), 56).bytes());
    EXPECT_TRUE(waitUntil([&] { return dropped() >= 4; }));  // the group, and ports of its own
    EXPECT_TRUE(hearsAgain()) << m_robot.out();
    ASSERT_FALSE(m_station->dropped().empty());
    EXPECT_EQ(m_station->dropped().front().from, "127.0.0.1");
}

TEST_F(Attack, HeartbeatsInTheRobotsNameMakeNobodySpin) {
    constexpr std::int64_t Huge = std::int64_t(1) << 62;
    std::vector<screen::EntityId> writers = {screen::entity::PublicationsWriter,
                                             screen::entity::SubscriptionsWriter,
                                             screen::entity::LivelinessWriter};
    for (const RemoteEndpoint& endpoint : m_station->endpoints()) {
        screen::EntityId id = 0;
        for (std::size_t i = 12; i < 16; ++i) id = id << 8 | endpoint.guid.bytes[i];
        if (endpoint.kind == RemoteEndpoint::Kind::Writer) writers.push_back(id);
    }
    ASSERT_GT(writers.size(), 3U);
    for (const screen::EntityId writer : writers) {
        for (unsigned i = 0; i < 12 * 17; ++i) {
            m_attacker.send(
                ofTheRobot(Packet().heartbeat(writer, i % 2 == 0 ? 1 : Huge, Huge, 1'000'000 + i)));
            m_attacker.send(ofTheRobot(Packet().gap(writer, 1, i % 2 == 0 ? 1 << 30 : Huge)));
        }
    }
    EXPECT_TRUE(waitUntil([&] { return dropped() >= 12; }));
    EXPECT_TRUE(hearsAgain()) << m_robot.out();
}

TEST_F(Attack, AFewPacketsInTheNameOfANewRobotCostItNoMoreThanAFewSamples) {
    // In its first seconds a participant may speak from any port of its host.
    const screen::EntityId odometry = odometryWriter();
    ASSERT_NE(odometry, 0U);
    for (int i = 0; i < 17; ++i) {
        m_attacker.send(ofTheRobot(Packet().gap(odometry, 1, 50'000)));
        m_attacker.send(ofTheRobot(Packet().heartbeat(odometry, 50'000, 50'100, 10'000)));
    }
    EXPECT_TRUE(hearsAgain()) << m_robot.out();
}

TEST_F(Attack, NobodySendsTheRobotAwayOrTakesItsPlace) {
    const std::vector<Bytes> packets = {end(screen::entity::ParticipantWriter, 0x000001c1, 1'000),
                                        ofTheRobot(Packet().announce(0))};
    for (const Bytes& one : packets) m_attacker.announce(one);
    EXPECT_TRUE(waitUntil([&] { return dropped() >= 2; }));
    EXPECT_TRUE(hearsAgain());
    EXPECT_NE(robotsPrefix(), screen::Prefix{});
}

TEST_F(Attack, NobodyTakesBackWhatANewRobotAnnouncedOfItsWriters) {
    const screen::EntityId odometry = odometryWriter();
    ASSERT_NE(odometry, 0U);
    for (std::int64_t number = 1; number < 64; ++number)
        m_attacker.announce(end(screen::entity::PublicationsWriter, odometry, number));
    EXPECT_TRUE(waitUntil([&] { return dropped() >= 2; }));
    EXPECT_TRUE(hearsAgain()) << m_robot.out();
}

TEST_F(Attack, ManyWhoAppearAtOnceHarmNobody) {
    for (int i = 0; i < 60; ++i) m_attacker.announce(Packet(100 + i).announce(100, 0).bytes());
    EXPECT_TRUE(waitUntil([&] { return m_station->participants().size() > 60; }, 10s));
    EXPECT_TRUE(hearsAgain()) << m_robot.out();
}

TEST_F(Attack, MutatedTrafficOfTheDomainHarmsNobody) {
    std::vector<RecordedPacket> recorded;
    {
        NodeSettings settings;
        settings.domain = m_domain.number();
        settings.interfaces = {"lo"};
        RecordingParticipant ear(settings);
        ear.listen("/k/odom", reliable(10));
        ASSERT_TRUE(waitUntil([&] { return ear.arrived() > 300; }, 30s));
        recorded = ear.packets();
    }
    Mutator mutator(recorded, 11);
    for (const Mutation how : {Mutation::Anywhere, Mutation::InFields, Mutation::InPayload}) {
        for (int i = 0; i < 10'000; ++i) m_attacker.send(mutator.next(how));
        EXPECT_TRUE(hearsAgain()) << static_cast<int>(how) << ": " << m_robot.out();
    }
    EXPECT_GT(dropped(), 1'000U);
}

}  // namespace
}  // namespace leitstand::test
