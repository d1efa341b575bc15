#include "transport/dds/ros_nodes.h"

#include <algorithm>
#include <bit>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "tests/transport/dds/test_node.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/dds/ros_presence.h"

namespace leitstand::test {
namespace {

Guid guid(std::uint8_t first, std::uint8_t entity) {
    Guid guid;
    guid.bytes.fill(first);
    guid.bytes.back() = entity;
    return guid;
}

/// A process as rmw announces it, with identities of @p gidSize bytes: a driver at /kurt3d, with two writers
/// and a reader, and a node without a namespace.
std::vector<std::byte> announced(std::size_t gidSize, const Guid& participant, const Guid& writer,
                                 std::endian order = std::endian::little) {
    CdrWriter out(order);
    const auto put = [&](const Guid& one) {
        for (const std::uint8_t byte : one.bytes) out.write(byte);
        for (std::size_t i = one.bytes.size(); i < gidSize; ++i) out.write(std::uint8_t{0});
    };
    put(participant);
    out.write(std::uint32_t{2});
    out.write(std::string("/kurt3d"));
    out.write(std::string("driver"));
    out.write(std::uint32_t{1});
    put(guid(1, 7));
    out.write(std::uint32_t{2});
    put(writer);
    put(guid(1, 9));
    out.write(std::string("/"));
    out.write(std::string("tf"));
    out.write(std::uint32_t{0});
    out.write(std::uint32_t{0});
    return std::move(out).finish();
}

TEST(RosNodes, AreReadWithIdentitiesOfBothSizes) {
    for (const std::size_t size : {16U, 24U}) {
        for (const std::endian order : {std::endian::little, std::endian::big}) {
            const auto process = rosProcess(announced(size, guid(1, 0xc1), guid(1, 8), order));
            ASSERT_TRUE(process.ok()) << size << ": " << process.error().text;
            EXPECT_EQ(process->gidSize, size);
            EXPECT_EQ(process->participant, guid(1, 0xc1));
            ASSERT_EQ(process->nodes.size(), 2U);
            EXPECT_EQ(process->nodes[0].name, "/kurt3d/driver");
            EXPECT_THAT(process->nodes[0].writers, testing::ElementsAre(guid(1, 8), guid(1, 9)));
            EXPECT_EQ(process->nodes[1].name, "/tf");
        }
    }
}

TEST(RosNodes, OfWhatIsNoAnnouncementAreNone) {
    const auto whole = announced(24, guid(1, 0xc1), guid(1, 8));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        // The beginning of a long identity may be a short one of a process without nodes.
        const auto process = rosProcess(std::span(whole).first(size));
        EXPECT_TRUE(!process.ok() || process->nodes.empty()) << size;
    }
    auto huge = whole;
    std::fill_n(huge.begin() + 4 + 24, 4, std::byte{0xff});
    EXPECT_FALSE(rosProcess(huge).ok()) << "four thousand million nodes";
    std::mt19937 random(5);
    for (int i = 0; i < 20'000; ++i) {
        auto flipped = announced(i % 2 == 0 ? 16 : 24, guid(1, 0xc1), guid(1, 8));
        for (int k = 0; k < 3; ++k) flipped[random() % flipped.size()] = static_cast<std::byte>(random());
        static_cast<void>(rosProcess(flipped));
    }
}

TEST(RosNodes, TheNewestAnnouncementOfAProcessCounts) {
    RosNodes nodes;
    nodes.add({guid(1, 0xc1), 16, {{"/a/driver", {}, {guid(1, 8)}}, {"/a/camera", {guid(1, 7)}, {}}}});
    EXPECT_EQ(nodes.of(guid(1, 8)), "/a/driver");
    EXPECT_EQ(nodes.of(guid(1, 7)), "/a/camera");
    nodes.add({guid(1, 0xc1), 16, {{"/a/other", {}, {guid(1, 8)}}}});
    EXPECT_EQ(nodes.of(guid(1, 8)), "/a/other");
    EXPECT_EQ(nodes.of(guid(1, 7)), "") << "that node has ended";
    EXPECT_EQ(nodes.of(guid(2, 8)), "");
}

TEST(RosNodes, AreHeardOfProcessesInTheDomain) {
    const TestDomain domain;
    const auto robot = nodeIn(domain, {.name = "/"});
    const auto odometry = must(robot->publisher({"/odom", "nav_msgs/msg/Odometry", reliable(1)}));
    const auto announcing = must(
        robot->publisher({std::string(RosDiscoveryTopic), std::string(RosDiscoveryType), transientLocal(1)}));
    for (const std::size_t size : {24U, 16U}) {
        const auto station = nodeIn(domain);
        const RosNodeWatch watch(*station);
        EXPECT_EQ(watch.nodes().of(odometry->guid()), "");
        ASSERT_TRUE(announcing
                        ->write(std::make_shared<const std::vector<std::byte>>(
                            announced(size, robot->guid(), odometry->guid())))
                        .ok());
        EXPECT_TRUE(waitUntil([&] { return watch.nodes().of(odometry->guid()) == "/kurt3d/driver"; }))
            << size;
    }
}

TEST(RosNodes, AreAnnouncedAsTheyAreRead) {
    for (const std::size_t size : {16U, 24U}) {
        const RosProcess process{
            guid(1, 0xc1),
            size,
            {{"/leitstand", {guid(1, 7)}, {guid(1, 8), guid(1, 9)}}, {"/a/b/c", {}, {}}}};
        const auto read = rosProcess(*rosAnnouncement(process));
        ASSERT_TRUE(read.ok()) << read.error().text;
        EXPECT_EQ(read->gidSize, size);
        EXPECT_EQ(read->participant, process.participant);
        ASSERT_EQ(read->nodes.size(), 2U);
        EXPECT_EQ(read->nodes[0].name, "/leitstand");
        EXPECT_EQ(read->nodes[0].readers, process.nodes[0].readers);
        EXPECT_EQ(read->nodes[0].writers, process.nodes[0].writers);
        EXPECT_EQ(read->nodes[1].name, "/a/b/c");
    }
    EXPECT_EQ(
        announced(24, guid(1, 0xc1), guid(1, 8)),
        *rosAnnouncement({guid(1, 0xc1),
                          24,
                          {{"/kurt3d/driver", {guid(1, 7)}, {guid(1, 8), guid(1, 9)}}, {"/tf", {}, {}}}}))
        << "byte for byte as rmw does";
}

TEST(RosNodes, TheSizeOfIdentitiesIsKnownOnlyWhereAllAgree) {
    RosNodes nodes;
    const std::vector all = {guid(1, 0xc1), guid(2, 0xc1), guid(3, 0xc1)};
    EXPECT_EQ(nodes.gidSize(all), std::nullopt);
    nodes.add({guid(1, 0xc1), 24, {{"/a", {}, {}}}});
    EXPECT_EQ(nodes.gidSize(all), 24U);
    nodes.add({guid(2, 0xc1), 16, {{"/leitstand", {}, {}}}});
    EXPECT_EQ(nodes.gidSize(all), std::nullopt);
    EXPECT_EQ(nodes.gidSize(all, "/leitstand"), 24U) << "stations go by the robots";
    EXPECT_EQ(nodes.gidSize(std::vector{guid(2, 0xc1)}), 16U) << "the other one has gone";
}

/// What a process of ROS 2 hears of others on its topic of nodes.
class Heard {
public:
    explicit Heard(Node& node)
        : m_subscription(must(node.subscribe(
              {std::string(RosDiscoveryTopic), std::string(RosDiscoveryType), transientLocal(1), Lane::Small},
              [this](const ReceivedSample& sample) {
                  const std::lock_guard lock(m_mutex);
                  if (auto process = rosProcess(*sample.event.cdr))
                      m_all.push_back(std::move(process).value());
              }))) {}
    /// The newest announcement of @p participant.
    [[nodiscard]] std::optional<RosProcess> of(const Guid& participant) const {
        const std::lock_guard lock(m_mutex);
        const auto found = std::find_if(m_all.rbegin(), m_all.rend(), [&](const RosProcess& one) {
            return one.participant == participant;
        });
        return found == m_all.rend() ? std::nullopt : std::optional(*found);
    }

private:
    mutable std::mutex m_mutex;
    std::vector<RosProcess> m_all;
    std::unique_ptr<Subscription> m_subscription;
};

TEST(RosPresence, IsAnnouncedInTheSizeThatIsHeardAndNotWhereSizesAreMixed) {
    for (const std::size_t size : {24U, 16U}) {
        const TestDomain domain;
        const auto robot = nodeIn(domain, {.name = "/"}), station = nodeIn(domain);
        const Heard heard(*robot);
        const auto odometry = must(station->subscribe(
            {"/odom", "nav_msgs/msg/Odometry", reliable(1), Lane::Small}, [](const ReceivedSample&) {}));
        const RosNodeWatch watch(*station);
        const RosPresence presence(*station, watch.nodes(), "/leitstand");
        std::this_thread::sleep_for(std::chrono::milliseconds(1'500));
        EXPECT_FALSE(heard.of(station->guid())) << "nobody has said how long identities are";
        const auto announcing = must(robot->publisher(
            {std::string(RosDiscoveryTopic), std::string(RosDiscoveryType), transientLocal(1)}));
        ASSERT_TRUE(announcing
                        ->write(std::make_shared<const std::vector<std::byte>>(
                            announced(size, robot->guid(), guid(9, 8))))
                        .ok());
        ASSERT_TRUE(waitUntil([&] {
            const auto said = heard.of(station->guid());
            return said && said->gidSize == size && said->nodes.size() == 1 &&
                   std::count(said->nodes[0].readers.begin(), said->nodes[0].readers.end(),
                              odometry->guid()) == 1;
        }));
        const auto later = must(station->publisher({"/cmd_vel", "geometry_msgs/msg/Twist", reliable(1)}));
        EXPECT_TRUE(waitUntil([&] {
            const std::vector<Guid> writers = heard.of(station->guid())->nodes[0].writers;
            return std::count(writers.begin(), writers.end(), later->guid()) == 1;
        })) << "what came later, too";
        // One of the other kind comes: it hears nothing in a size that would break it.
        const auto other = nodeIn(domain, {.name = "/"});
        const auto its = must(other->publisher(
            {std::string(RosDiscoveryTopic), std::string(RosDiscoveryType), transientLocal(1)}));
        ASSERT_TRUE(its->write(std::make_shared<const std::vector<std::byte>>(
                                   announced(40 - size, other->guid(), guid(9, 9))))
                        .ok());
        const auto announces = [&] {
            const auto endpoints = robot->endpoints();
            return std::any_of(endpoints.begin(), endpoints.end(), [&](const RemoteEndpoint& one) {
                return one.kind == RemoteEndpoint::Kind::Writer && one.participant == station->guid() &&
                       one.topic == RosDiscoveryTopic;
            });
        };
        EXPECT_TRUE(waitUntil([&] { return !announces(); }));
    }
}

}  // namespace
}  // namespace leitstand::test
