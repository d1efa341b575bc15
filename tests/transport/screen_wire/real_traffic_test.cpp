#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>

#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/missing_tool.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/cyclone/loopback.h"
#include "tests/transport/dds/test_node.h"
#include "tests/transport/screen_wire/recorded_traffic.h"
#include "transport/security/authorities.h"
#include "transport/security/enclave.h"
#include "transport/security/keys.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

NodeSettings onLoopback(const TestDomain& domain) {
    NodeSettings settings;
    settings.domain = domain.number();
    settings.interfaces = {"lo"};
    return settings;
}

/// A robot of ours that says what robots say, as fast as it can: small samples of both kinds, and large ones.
class Speaker {
public:
    explicit Speaker(NodeSettings settings) {
        settings.name = "speaker";
        settings.telemetryLimit = settings.scanLimit = settings.pictureLimit = {0, 1};
        m_node = must(Node::create(settings));
        m_fast = must(m_node->publisher({"/kurt3d/odom", TestType, bestEffort(), Flow::Immediate}));
        m_sure = must(m_node->publisher({"/kurt3d/mode", TestType, reliable(100), Flow::Immediate}));
        m_large = must(m_node->publisher({"/kurt3d/points", TestType, reliable(20), Flow::Scans}));
    }
    [[nodiscard]] bool matched() const {
        return m_fast->matched() > 0 && m_sure->matched() > 0 && m_large->matched() > 0;
    }
    [[nodiscard]] bool matchedMode() const { return m_sure->matched() > 0; }
    void publish(std::uint32_t i) {
        static_cast<void>(m_fast->write(testPayload(700, i)));
        if (i % 4 == 0) static_cast<void>(m_sure->write(testPayload(120, i)));
        if (i % 200 == 0) static_cast<void>(m_large->write(testPayload(400'000, i)));
    }

private:
    std::unique_ptr<Node> m_node;
    std::unique_ptr<Publisher> m_fast, m_sure, m_large;
};

/// The name of this computer, which participants tell, made to another one of its length.
void hideHost(std::vector<std::byte>& bytes) {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) return;
    const std::string host = name.data();
    const auto same = [](std::byte a, char b) { return a == static_cast<std::byte>(b); };
    for (auto at = bytes.begin(); !host.empty();) {
        at = std::search(at, bytes.end(), host.begin(), host.end(), same);
        if (at == bytes.end()) return;
        at = std::fill_n(at, host.size(), std::byte{'h'});
    }
}

/// Keeps a packet of each make as a seed of fuzz_screen in the folder that LEITSTAND_SEEDS names.
void keepSeed(const std::string& name, const RecordingParticipant& listener, bool encrypted) {
    constexpr std::size_t MostBytes = 6'000, LargestPacket = 1'200;
    const char* folder = std::getenv("LEITSTAND_SEEDS");
    if (folder == nullptr) return;
    std::string seed(1, encrypted ? '\1' : '\0');
    std::set<std::vector<screen::EntityId>> makes;
    screen::Datagram datagram;
    for (RecordedPacket packet : listener.packets()) {
        std::vector<screen::EntityId> make;
        static_cast<void>(screen::parse(packet.bytes, datagram));
        for (const auto& one : datagram.submessages) {
            make.push_back(static_cast<screen::EntityId>(one.kind));
            make.push_back(one.writer);
        }
        const bool fits =
            packet.bytes.size() <= LargestPacket && seed.size() + packet.bytes.size() < MostBytes;
        if (!fits || !makes.insert(make).second) continue;
        hideHost(packet.bytes);
        const unsigned sender = std::accumulate(packet.bytes.begin() + 8, packet.bytes.begin() + 20, 0U,
                                                [](unsigned sum, std::byte b) { return sum + unsigned(b); });
        seed += {static_cast<char>(sender), static_cast<char>(packet.bytes.size()),
                 static_cast<char>(packet.bytes.size() >> 8)};
        seed.append(reinterpret_cast<const char*>(packet.bytes.data()), packet.bytes.size());
    }
    std::ofstream(std::filesystem::path(folder) / name, std::ios::binary) << seed;
}

std::string dropsOf(const RecordingParticipant& participant) {
    std::string text;
    for (const ScreenDrop& drop : participant.gate().drops()) text += toString(drop) + "; ";
    return text + std::string(participant.gate().lastFault());
}

/// Of the packets that @p participant keeps, those that end with a submessage of statistics.
std::size_t withStatistics(const RecordingParticipant& participant) {
    const auto packets = participant.packets();
    screen::Datagram datagram;
    return static_cast<std::size_t>(std::count_if(packets.begin(), packets.end(), [&](const auto& packet) {
        return screen::parse(packet.bytes, datagram).empty() &&
               datagram.submessages.back().kind == screen::Kind::Statistics;
    }));
}

/// Has a robot speak until @p count datagrams have come; all have to pass, bit for bit.
void expectAllPass(const NodeSettings& station, const NodeSettings& robot, std::uint64_t count) {
    RecordingParticipant listener(station);
    listener.listen("/kurt3d/odom", bestEffort());
    for (const char* topic : {"/kurt3d/mode", "/kurt3d/points"}) listener.listen(topic, reliable(20));
    Speaker speaker(robot);
    ASSERT_TRUE(waitUntil([&] { return speaker.matched(); }, 30s));
    std::uint32_t i = 0;
    ASSERT_TRUE(waitUntil(
        [&] {
            for (int burst = 0; burst < 20; ++burst) speaker.publish(++i);
            return listener.arrived() >= count;
        },
        20min));
    keepSeed(station.security ? "fastdds-secured" : "fastdds", listener, station.security.has_value());
    EXPECT_EQ(dropsOf(listener), "");
    EXPECT_TRUE(listener.same());
    EXPECT_TRUE(waitUntil([&] { return listener.passed() == listener.arrived(); }));
    const std::size_t statistics = withStatistics(listener);
    EXPECT_GT(statistics, 0U);  // both Debians build the library with them
    std::printf("screen: %llu packets passed bit for bit%s, %zu with statistics\n",
                static_cast<unsigned long long>(listener.passed()), station.security ? ", secured" : "",
                statistics);
}

class RealTraffic : public ::testing::Test {
protected:
    void makeKeys() {
        const auto made = createKeys(m_folder / "keys", {{KeyRole::Station, "station1", {}, false},
                                                         {KeyRole::Robot, "kurt3d", {}, false}});
        ASSERT_TRUE(made.ok()) << made.error().text;
    }
    [[nodiscard]] NodeSettings secured(const std::string& name) const {
        NodeSettings settings = onLoopback(m_domain);
        settings.security = must(securityFiles(m_folder / "keys" / "enclaves" / name));
        return settings;
    }
    const TestDomain m_domain;
    const TemporaryFolder m_folder;
};
class RealTrafficLong : public RealTraffic {};

TEST_F(RealTraffic, OfFastDdsPasses) {
    expectAllPass(onLoopback(m_domain), onLoopback(m_domain), 20'000);
}
TEST_F(RealTraffic, OfFastDdsWithKeysPasses) {
    makeKeys();
    expectAllPass(secured("station1"), secured("kurt3d"), 10'000);
}
TEST_F(RealTrafficLong, AMillionPacketsOfFastDdsPass) {
    expectAllPass(onLoopback(m_domain), onLoopback(m_domain), 1'000'000);
}
TEST_F(RealTrafficLong, AMillionPacketsOfFastDdsWithKeysPass) {
    makeKeys();
    expectAllPass(secured("station1"), secured("kurt3d"), 1'000'000);
}

TEST_F(RealTraffic, OfCycloneDdsPasses) {
    const std::string program = test::program("cyclone_peer");
    if (!std::filesystem::exists(program))
        LEITSTAND_MISSING_TOOL(
            "Cyclone DDS was not found at build (Debian: cyclonedds-dev, cyclonedds-tools)");
    NodeSettings settings = onLoopback(m_domain);
    settings.multicast = false;
    settings.initialPeers = {"127.0.0.1"};
    RecordingParticipant listener(settings);
    for (const char* package : {"sensor_msgs/PointCloud2", "sensor_msgs/Image", "nav_msgs/Odometry"}) {
        std::string type = package;
        type.replace(type.find('/'), 1, "/msg/");
        listener.listen(std::string("/cyclone/") + package, transientLocal(100), type);
    }
    const ChildProcess peer(program, {std::to_string(m_domain.number()), "20"}, {LoopbackOnly});
    EXPECT_TRUE(waitUntil([&] { return listener.arrived() > 150; }, 60s)) << listener.arrived();
    keepSeed("cyclone", listener, false);
    EXPECT_EQ(dropsOf(listener), "");
    EXPECT_TRUE(listener.same());
    std::printf("screen: %llu packets of Cyclone DDS passed bit for bit\n",
                static_cast<unsigned long long>(listener.passed()));
}

TEST_F(RealTraffic, CostsTheScreenAMicrosecondAPacketAtMost) {
    RecordingParticipant listener(onLoopback(m_domain));
    listener.listen("/kurt3d/odom", bestEffort());
    for (const char* topic : {"/kurt3d/mode", "/kurt3d/points"}) listener.listen(topic, reliable(20));
    Speaker speaker(onLoopback(m_domain));
    ASSERT_TRUE(waitUntil([&] { return speaker.matched(); }, 30s));
    std::uint32_t i = 0;
    ASSERT_TRUE(waitUntil(
        [&] {
            for (int burst = 0; burst < 20; ++burst) speaker.publish(++i);
            return listener.arrived() > 3'000;
        },
        60s));
    const auto packets = listener.packets();
    screen::Screen gate({});
    constexpr int Rounds = 100;
    const std::clock_t began = std::clock();
    std::uint64_t passed = 0;
    for (int round = 0; round < Rounds; ++round) {
        for (const RecordedPacket& packet : packets)
            passed += gate.passes(packet.bytes, packet.place) ? 1U : 0U;
    }
    const double seconds = double(std::clock() - began) / CLOCKS_PER_SEC;
    EXPECT_EQ(passed, packets.size() * Rounds) << gate.lastFault();
    const double each = seconds / double(passed);
    std::printf("screen: %.0f ns a packet\n", each * 1e9);
    EXPECT_LT(each, 1e-6);
}

TEST_F(RealTraffic, WithKeysOnlyDiscoveryAndAuthenticationArePlain) {
    makeKeys();
    RecordingParticipant listener(secured("station1"));
    listener.listen("/kurt3d/mode", reliable(20));
    Speaker speaker(secured("kurt3d"));
    ASSERT_TRUE(waitUntil([&] { return speaker.matchedMode(); }, 30s));
    std::uint32_t i = 0;
    EXPECT_TRUE(waitUntil(
        [&] {
            speaker.publish(++i);
            return listener.arrived() > 200;
        },
        30s));
    std::set<screen::EntityId> plain;
    std::set<int> kinds;
    screen::Datagram datagram;
    for (const RecordedPacket& packet : listener.packets()) {
        ASSERT_EQ(screen::parse(packet.bytes, datagram), "");
        for (const screen::Submessage& one : datagram.submessages) {
            kinds.insert(static_cast<int>(one.kind));
            if (one.writer != 0 && !one.protectedBySignature) plain.insert(one.writer);
        }
    }
    EXPECT_EQ(plain, (std::set<screen::EntityId>{screen::entity::ParticipantWriter,
                                                 screen::entity::AuthenticationWriter}));
    EXPECT_TRUE(kinds.contains(0x33) && kinds.contains(0x31));  // messages, and keys for them
}

}  // namespace
}  // namespace leitstand::test
