#include "transport/dds/network/discovery_sender.h"

#include <cstring>
#include <map>

#include <gmock/gmock.h>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/transport/dds/test_node.h"
#include "tests/transport/screen/packets.h"
#include "tests/transport/screen_wire/one_locator.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
namespace rtps = detail::fastdds::rtps;
using Clock = std::chrono::steady_clock;

/// What a sender sends, and when.
class DiscoverySenderTest : public testing::Test {
protected:
    struct Sent {
        Clock::time_point at;
        Bytes bytes;
        std::vector<std::uint32_t> ports;
    };
    void send(const Bytes& bytes, std::uint32_t port = 7410) {
        const auto by = [this](std::span<const std::byte> what, rtps::LocatorsIterator& first,
                               rtps::LocatorsIterator& last, auto) {
            Sent sent{Clock::now(), {what.begin(), what.end()}, {}};
            for (; first != last; ++first) sent.ports.push_back((*first).port);
            const std::scoped_lock lock(m_mutex);
            m_sent.push_back(std::move(sent));
            return true;
        };
        OneLocator first(port, false), last(port, true);
        EXPECT_TRUE(m_sender.send(bytes, first, last, Clock::now() + 1s, by));
    }
    [[nodiscard]] std::vector<Sent> sent() {
        const std::scoped_lock lock(m_mutex);
        return m_sent;
    }
    /// How often what was sent has gone out in the end.
    [[nodiscard]] std::size_t times() {
        m_sender.finish();
        return sent().size();
    }

    std::mutex m_mutex;
    std::vector<Sent> m_sent;
    std::shared_ptr<screen::Screen> m_screen = std::make_shared<screen::Screen>(screen::ScreenSettings{});
    detail::DiscoverySender m_sender{m_screen};
};

const Bytes& hidden() {
    static const Bytes bytes = Packet()
                                   .submessage(0x33, 0, Bytes(20))
                                   .submessage(0x30, 0, ByteWriter(false).u32(40).zeros(40).bytes)
                                   .submessage(0x34, 0, Bytes(20))
                                   .bytes();
    return bytes;
}

TEST_F(DiscoverySenderTest, DiscoveryGoesOutAgainALittleLaterInItsOrder) {
    const Bytes first = Packet().announce().bytes();
    const Bytes second = Packet().heartbeat(screen::entity::PublicationsWriter, 1, 4).bytes();
    send(first, 7410);
    send(second, 7412);
    ASSERT_TRUE(waitUntil([this] { return sent().size() == 6; }));
    const auto all = sent();
    for (const std::size_t i : {0, 1, 2, 3}) {
        EXPECT_EQ(all[i + 2].bytes, all[i].bytes);
        EXPECT_EQ(all[i + 2].ports, all[i].ports);
        EXPECT_GE(all[i + 2].at - all[i].at, 20ms);
    }
    EXPECT_EQ(all[0].bytes, first);
    EXPECT_THAT(all[1].ports, testing::ElementsAre(7412U));
    EXPECT_EQ(times(), 6U);
}

TEST_F(DiscoverySenderTest, SamplesGoOutOnce) {
    send(Packet().data(OdometryWriter, 1, Bytes(8)).bytes());
    EXPECT_EQ(times(), 1U);
}

TEST_F(DiscoverySenderTest, WhatIsEncryptedGoesOutAgainWhereOnlyDiscoveryIsHeard) {
    ASSERT_TRUE(m_screen->passes(Packet().announcePorts({7410}, {7411}).bytes(), placeOf(7)));
    send(hidden(), 7410);
    send(hidden(), 7411);
    send(hidden(), 7412);  // nobody said what is heard there
    EXPECT_EQ(times(), 5U);
    EXPECT_THAT(sent().back().ports, testing::ElementsAre(7410U));
}

TEST_F(DiscoverySenderTest, WhatWaitsAtTheEndGoesOutBeforeItAndWhatComesLaterThreeTimesAtOnce) {
    send(Packet().announce().bytes());
    m_sender.finish();
    EXPECT_EQ(sent().size(), 3U);
    send(Packet().announce().bytes());
    EXPECT_EQ(sent().size(), 6U);
}

TEST_F(DiscoverySenderTest, WhatWaitsIsBounded) {
    const Bytes large = Packet().data(screen::entity::PublicationsWriter, 1, Bytes(60'000)).bytes();
    const auto begin = Clock::now();
    for (int i = 0; i < 100; ++i) send(large);
    // On a slow machine repetitions are due meanwhile, and make room for others.
    const auto meanwhile = static_cast<std::size_t>((Clock::now() - begin) / 20ms);
    EXPECT_GE(times(), 120U);
    EXPECT_LE(sent().size(), 140U + 40U * meanwhile);
}

/// The numbers of announcements that came, each with the moments when.
using Announced = std::map<std::int64_t, std::vector<Clock::time_point>>;

/// Listens as a peer that a node was told of.
class Peer {
public:
    Peer() : m_socket(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in own{};
        own.sin_family = AF_INET;
        own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof own;
        EXPECT_EQ(bind(m_socket, reinterpret_cast<sockaddr*>(&own), sizeof own), 0);
        EXPECT_EQ(getsockname(m_socket, reinterpret_cast<sockaddr*>(&own), &size), 0);
        m_port = ntohs(own.sin_port);
        const timeval patience{0, 100'000};
        setsockopt(m_socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }
    ~Peer() { close(m_socket); }
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    [[nodiscard]] std::string name() const { return "127.0.0.1:" + std::to_string(m_port); }
    void listen(Clock::duration howLong, Announced& to) const {
        Bytes bytes(65'536);
        screen::Datagram datagram;
        for (const auto end = Clock::now() + howLong; Clock::now() < end;) {
            const ssize_t size = recv(m_socket, bytes.data(), bytes.size(), 0);
            if (size <= 0) continue;
            EXPECT_EQ(screen::parse(std::span(bytes).first(static_cast<std::size_t>(size)), datagram), "");
            for (const screen::Submessage& one : datagram.submessages) {
                if (one.kind == screen::Kind::Data) to[one.first].push_back(Clock::now());
            }
        }
    }

private:
    int m_socket;
    std::uint16_t m_port = 0;
};

TEST(DiscoverySending, ANodeSaysEachAnnouncementAndItsGoodbyeThreeTimes) {
    const TestDomain domain;
    const Peer peer;
    NodeSettings settings;
    settings.interfaces = {"lo"};
    settings.initialPeers = {peer.name()};
    settings.multicast = false;
    auto node = nodeIn(domain, settings);
    Announced announced;
    peer.listen(1500ms, announced);
    std::size_t datagrams = 0;
    for (const auto& [number, moments] : announced) datagrams += moments.size();
    const auto last = announced.rbegin()->first;
    node.reset();
    peer.listen(500ms, announced);
    ASSERT_GT(announced.rbegin()->first, last) << "no goodbye";
    ASSERT_GE(datagrams, 6U);
    for (const auto& [number, moments] : announced) EXPECT_EQ(moments.size() % 3, 0U) << number;
    for (const auto& [number, moments] : announced) {
        if (number >= last) continue;  // what waited when it left went out at once
        EXPECT_GE(moments.back() - moments.front(), 20ms) << number;
    }
}

}  // namespace
}  // namespace leitstand::test
