#include <cstdlib>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/missing_tool.h"
#include "tests/support/places.h"
#include "tests/transport/cyclone/loopback.h"
#include "tests/transport/cyclone/our_types.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/message_catalog.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t Seeds = 20;

/// Built where Cyclone DDS is.
std::string peer() {
    return program("cyclone_peer");
}

/// A Cyclone process and a node of ours, by unicast.
class cyclone : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(peer())) {
            LEITSTAND_MISSING_TOOL(
                "Cyclone DDS was not found at build (Debian: cyclonedds-dev, cyclonedds-tools)");
        }
        m_peer = std::make_unique<ChildProcess>(
            peer(), std::vector{std::to_string(m_domain.number()), std::to_string(Seeds)},
            std::vector<std::string>{LoopbackOnly});
        NodeSettings settings;
        settings.interfaces = {"lo"};
        settings.initialPeers = {"127.0.0.1"};
        settings.multicast = false;
        m_node = nodeIn(m_domain, settings);
    }
    /// What arrives on @p prefix for each type; the subscriptions that fill it.
    void listen(const std::string& prefix) {
        for (const OurType& type : ourTypes()) {
            m_subscriptions.push_back(must(m_node->subscribe(
                {"/" + prefix + "/" + type.name, type.rosName, transientLocal(100), Lane::Large},
                m_inboxes[type.name].callback())));
        }
    }
    void expectAll() {
        for (const OurType& type : ourTypes()) {
            const Inbox& inbox = m_inboxes[type.name];
            ASSERT_TRUE(inbox.waitFor(Seeds))
                << type.rosName << ": " << inbox.size() << " samples; " << m_peer->out();
            const auto samples = inbox.samples();
            EXPECT_EQ(samples.size(), Seeds);
            for (std::uint32_t i = 0; i < Seeds; ++i) expectSame(*samples[i].event.cdr, type, i + 1);
        }
    }

    TestDomain m_domain;
    std::unique_ptr<ChildProcess> m_peer;
    std::map<std::string, Inbox> m_inboxes;
    std::unique_ptr<Node> m_node;
    std::vector<std::unique_ptr<Subscription>> m_subscriptions;

private:
    /// Same bytes; the two lowest bits of the options tell the padding (XTypes 1.3, section 7.6.3.1.2).
    static void expectSame(std::vector<std::byte> received, const OurType& type, std::uint32_t seed) {
        const auto expected = type.encoded(seed);
        const auto padding = std::to_integer<std::size_t>(received[3]);
        EXPECT_TRUE(padding == 0 || padding == received.size() - expected.size())
            << type.rosName << ", seed " << seed << ": " << padding;
        received[3] = std::byte{0};
        EXPECT_TRUE(sameBytes(received, expected)) << type.rosName << ", seed " << seed;
    }
};

TEST_F(cyclone, EveryTypeOfItArrivesAsOurEncoderMakesIt) {
    listen("cyclone");
    expectAll();
    EXPECT_TRUE(m_node->mismatches().empty());
}

TEST_F(cyclone, ReadsEveryTypeOfOursAndSendsTheSameBytesBack) {
    listen("echo");
    std::vector<std::unique_ptr<Publisher>> publishers;
    for (const OurType& type : ourTypes()) {
        publishers.push_back(must(
            m_node->publisher({"/ours/" + type.name, type.rosName, transientLocal(100), Flow::Immediate})));
        for (std::uint32_t seed = 1; seed <= Seeds; ++seed) {
            ASSERT_TRUE(
                publishers.back()->write(std::make_shared<const std::vector<std::byte>>(type.encoded(seed))));
        }
    }
    expectAll();
}

TEST(cycloneTypes, AreAllThatWeKnow) {
    EXPECT_EQ(ourTypes().size(), messageTypes().size());
}

TEST_F(cyclone, TopicsAreToldAsRosNames) {
    ASSERT_TRUE(waitUntil([&] { return m_node->endpoints().size() == 3 * ourTypes().size(); }));
    for (const RemoteEndpoint& endpoint : m_node->endpoints()) {
        EXPECT_TRUE(endpoint.ros);
        EXPECT_FALSE(endpoint.keyed);
        EXPECT_EQ(endpoint.qos.reliability, Qos::Reliability::Reliable);
        EXPECT_EQ(endpoint.qos.durability, Qos::Durability::TransientLocal);
        EXPECT_TRUE(endpoint.topic.ends_with(endpoint.type.substr(endpoint.type.rfind('/'))))
            << endpoint.topic;
    }
}

}  // namespace
}  // namespace leitstand::test
