#include <csignal>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

std::string peerArgument(const TestDomain& domain) {
    return std::to_string(domain.number());
}

TEST(PubSub, BytesArriveAsTheyWereWritten) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    Inbox inbox;
    const auto subscription = node->subscribe({"/k/odom", TestType, reliable(10)}, inbox.callback());
    const auto publisher = node->publisher({"/k/odom", TestType, reliable(10)});
    ASSERT_TRUE(waitUntil([&] { return (*publisher)->matched() == 1; }));
    const Time before = std::chrono::system_clock::now();
    for (std::uint32_t i = 1; i <= 5; ++i) ASSERT_TRUE((*publisher)->write(testPayload(101, i)));
    ASSERT_TRUE(inbox.waitFor(5));
    const auto samples = inbox.samples();
    for (std::uint32_t i = 0; i < 5; ++i) {
        EXPECT_TRUE(sameBytes(*samples[i].event.cdr, *testPayload(101, i + 1)));
        EXPECT_EQ(samples[i].event.topic, "/k/odom");
        EXPECT_EQ(samples[i].event.type, TestType);
        EXPECT_EQ(samples[i].writer, (*publisher)->guid());
        EXPECT_EQ(samples[i].writerSequence, i + 1);
        for (const Time time : {samples[i].sourceTime, samples[i].event.received}) {
            EXPECT_GE(time, before - 1ms);
            EXPECT_LE(time, std::chrono::system_clock::now() + 1ms);
        }
    }
    EXPECT_EQ((*subscription)->counts().samples, 5U);
    EXPECT_EQ((*subscription)->counts().lost, 0U);
    EXPECT_EQ((*subscription)->counts().writers, 1);
}

TEST(PubSub, BigEndianBytesPassUnchanged) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    Inbox inbox;
    const auto subscription = node->subscribe({"/k/odom", TestType, reliable(10)}, inbox.callback());
    const auto publisher = node->publisher({"/k/odom", TestType, reliable(10)});
    ASSERT_TRUE(waitUntil([&] { return (*publisher)->matched() == 1; }));
    auto bytes = *testPayload(37, 1);
    bytes[1] = std::byte{0};
    ASSERT_TRUE((*publisher)->write(std::make_shared<const std::vector<std::byte>>(bytes)));
    ASSERT_TRUE(inbox.waitFor(1));
    EXPECT_TRUE(sameBytes(*inbox.samples()[0].event.cdr, bytes));
}

TEST(PubSub, WhatIsNoSampleIsRefused) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    const auto publisher = node->publisher({"/k/odom", TestType, reliable(1)});
    const auto three = std::make_shared<const std::vector<std::byte>>(3);
    EXPECT_FALSE((*publisher)->write(nullptr));
    const auto written = (*publisher)->write(three);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text, testing::HasSubstr("/k/odom: a sample begins with 4 bytes"));
}

TEST(PubSub, ATopicHasOneTypeInANode) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    const auto publisher = node->publisher({"/k/odom", TestType, reliable(1)});
    const auto other = node->publisher({"/k/odom", "nav_msgs/msg/Odometry", reliable(1)});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().text,
              "/k/odom: is used here as std_msgs/msg/String already, not as nav_msgs/msg/Odometry");
}

TEST(PubSub, BetweenTwoProcessesAndBack) {
    const TestDomain domain;
    const ChildProcess peer(program("dds_peer"), {"echo", peerArgument(domain), "/k/cmd", "depth=100"});
    const auto node = nodeIn(domain);
    Inbox inbox;
    const auto subscription = node->subscribe({"/k/cmd/back", TestType, reliable(100)}, inbox.callback());
    const auto publisher = node->publisher({"/k/cmd", TestType, reliable(100), Flow::Immediate});
    ASSERT_TRUE(
        waitUntil([&] { return (*publisher)->matched() == 1 && (*subscription)->counts().writers == 1; }));
    // Samples to a reader that matches us a moment later than we match it would be lost: ask until answered.
    ASSERT_TRUE(waitUntil([&] {
        EXPECT_TRUE((*publisher)->write(testPayload(8, 0)));
        return inbox.waitFor(1, 50ms);
    }));
    for (std::uint32_t i = 1; i <= 50; ++i) ASSERT_TRUE((*publisher)->write(testPayload(1000 * i, i)));
    ASSERT_TRUE(waitUntil([&] { return inbox.size() > 0 && seedOf(inbox.samples().back()) == 50; }));
    const auto samples = inbox.samples();
    ASSERT_GT(samples.size(), 50U);
    for (std::uint32_t i = 1; i <= 50; ++i) {
        EXPECT_TRUE(sameBytes(*samples[samples.size() - 51 + i].event.cdr, *testPayload(1000 * i, i)));
    }
    EXPECT_TRUE((*publisher)->waitForAcknowledgments(2s));
}

TEST(PubSub, ALateJoinerGetsWhatIsTransientLocal) {
    const TestDomain domain;
    const auto early = nodeIn(domain);
    const Qos kept = transientLocal(50);
    const auto publisher = early->publisher({"/k/tf_static", TestType, kept});
    for (std::uint32_t i = 1; i <= 60; ++i) ASSERT_TRUE((*publisher)->write(testPayload(2000, i)));
    const auto late = nodeIn(domain);
    Inbox inbox;
    const auto subscription = late->subscribe({"/k/tf_static", TestType, kept}, inbox.callback());
    ASSERT_TRUE(inbox.waitFor(50));
    EXPECT_EQ(seedOf(inbox.samples().front()), 11U);
    EXPECT_EQ(seedOf(inbox.samples().back()), 60U);
}

TEST(PubSub, TwoHundredSamplesOfAMegabyteAllArrive) {
    const TestDomain domain;
    const ChildProcess peer(program("dds_peer"),
                            {"talk", peerArgument(domain), "/k/points", "count=200", "size=1000000",
                             "depth=200", "period=5", "flow=2", "limit=0"});
    const auto node = nodeIn(domain);
    Inbox inbox;
    const auto subscription =
        node->subscribe({"/k/points", TestType, reliable(200), Lane::Large}, inbox.callback());
    // The first may be written before the writer knows us, so the last is what tells.
    ASSERT_TRUE(waitUntil([&] { return inbox.size() > 0 && seedOf(inbox.samples().back()) == 200; }, 60s));
    EXPECT_EQ(inbox.size(), 200U);
    EXPECT_EQ((*subscription)->counts().lost, 0U);
    EXPECT_TRUE(sameBytes(*inbox.samples().back().event.cdr, *testPayload(1'000'000, 200)));
}

TEST(PubSub, LossesAreCountedByTheWritersNumbers) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    Inbox inbox;
    std::atomic<bool> blocked = true;
    const auto subscription =
        node->subscribe({"/k/imu", TestType, reliable(1)}, [&, keep = inbox.callback()](auto sample) {
            keep(std::move(sample));
            EXPECT_TRUE(waitUntil([&] { return !blocked; }));
        });
    const auto publisher = node->publisher({"/k/imu", TestType, reliable(1), Flow::Immediate});
    ASSERT_TRUE(waitUntil([&] { return (*subscription)->counts().writers == 1; }));
    ASSERT_TRUE((*publisher)->write(testPayload(10, 1)));
    ASSERT_TRUE(inbox.waitFor(1));
    for (std::uint32_t i = 2; i <= 101; ++i) ASSERT_TRUE((*publisher)->write(testPayload(10, i)));
    ASSERT_TRUE((*publisher)->waitForAcknowledgments(5s));  // all came, and one of them waits to be taken
    blocked = false;
    EXPECT_TRUE(waitUntil([&] { return inbox.samples().back().writerSequence == 101; }));
    EXPECT_TRUE(waitUntil([&] {
        const auto counts = (*subscription)->counts();
        return counts.lost + counts.samples == 101;
    }));
    EXPECT_GT((*subscription)->counts().lost, 0U);
}

TEST(PubSub, OutlivesItsNodeInSilence) {
    const TestDomain domain;
    auto node = nodeIn(domain);
    Inbox inbox;
    const auto subscription = node->subscribe({"/k/odom", TestType, reliable(1)}, inbox.callback());
    const auto publisher = node->publisher({"/k/odom", TestType, reliable(1)});
    node.reset();
    const auto written = (*publisher)->write(testPayload(10, 1));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().text, "/k/odom: the node has left its domain");
    EXPECT_EQ((*publisher)->matched(), 0);
    EXPECT_FALSE((*publisher)->waitForAcknowledgments(1s));
    EXPECT_EQ((*subscription)->counts().writers, 0);
}

}  // namespace
}  // namespace leitstand::test
