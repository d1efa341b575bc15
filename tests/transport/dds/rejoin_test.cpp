#include <algorithm>
#include <atomic>
#include <deque>
#include <filesystem>
#include <iterator>
#include <set>
#include <thread>

#include <gmock/gmock.h>

#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

std::size_t writersOf(const Inbox& inbox) {
    std::set<Guid> writers;
    for (const ReceivedSample& sample : inbox.samples()) writers.insert(sample.writer);
    return writers.size();
}

TEST(Rejoin, SubscriptionsAndPublishersGoOnAsAnotherParticipant) {
    const TestDomain domain;
    const auto robot = nodeIn(domain, {.name = "kurt3d"}), station = nodeIn(domain);
    Inbox odometry, commands;
    const auto received = must(station->subscribe({"/k/odom", TestType, bestEffort()}, odometry.callback()));
    const auto obeyed = must(robot->subscribe({"/k/cmd_vel", TestType, reliable(1)}, commands.callback()));
    const auto reported = must(robot->publisher({"/k/odom", TestType, bestEffort()}));
    const auto driven = must(station->publisher({"/k/cmd_vel", TestType, reliable(1), Flow::Immediate}));
    const auto bothHear = [&] {
        const std::size_t before = odometry.size(), obeyedBefore = commands.size();
        return waitUntil([&] {
            static_cast<void>(reported->write(testPayload(100, 1)));
            static_cast<void>(driven->write(testPayload(100, 1)));
            return odometry.size() > before && commands.size() > obeyedBefore;
        });
    };
    ASSERT_TRUE(bothHear());
    const Guid before = station->guid();
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(station->rejoin());
        ASSERT_TRUE(bothHear());
    }
    EXPECT_NE(station->guid(), before);
    EXPECT_EQ(writersOf(commands), 4U) << "robots see a new publisher each time";
    EXPECT_TRUE(waitUntil([&] { return robot->participants().size() == 1U; })) << "the one before is gone";
    EXPECT_TRUE(station->mismatches().empty());
}

/// Of this process; those that are ending are waited for.
std::size_t restingThreads() {
    const auto now = [] {
        const std::filesystem::directory_iterator tasks("/proc/self/task");
        return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
    };
    std::size_t least = now();
    for (int i = 0; i < 10; ++i) {
        std::this_thread::sleep_for(50ms);
        least = std::min(least, now());
    }
    return least;
}

TEST(Rejoin, LeavesNoThreadsOfTheParticipantBefore) {
    const TestDomain domain;
    const auto robot = nodeIn(domain, {.name = "kurt3d"}), station = nodeIn(domain);
    Inbox odometry;
    const auto received = must(station->subscribe({"/k/odom", TestType, reliable(5)}, odometry.callback()));
    const auto reported = must(robot->publisher({"/k/odom", TestType, reliable(5)}));
    const auto driven = must(station->publisher({"/k/cmd_vel", TestType, reliable(1), Flow::Immediate}));
    ASSERT_TRUE(station->rejoin());  // what the library starts once is there
    const std::size_t before = restingThreads();
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(station->rejoin());
    EXPECT_EQ(restingThreads(), before);
}

TEST(Rejoin, WhatIsTransientLocalIsWrittenAgainForThoseWhoJoinLater) {
    const TestDomain domain;
    const auto station = nodeIn(domain);
    const auto stop = must(station->publisher({"/k/stop_cmd", TestType, transientLocal(2), Flow::Immediate}));
    for (std::uint32_t i = 1; i <= 3; ++i) ASSERT_TRUE(stop->write(testPayload(100, i)));
    ASSERT_TRUE(station->rejoin());
    const auto robot = nodeIn(domain);
    Inbox ear;
    const auto received =
        must(robot->subscribe({"/k/stop_cmd", TestType, transientLocal(10)}, ear.callback()));
    EXPECT_TRUE(waitUntil([&] { return ear.size() == 2U; })) << "as many as the history keeps";
}

TEST(Rejoin, AHistoryThatIsToKeepAllIsBoundedAndWrittenAgain) {
    const TestDomain domain;
    const auto station = nodeIn(domain);
    const auto reported = must(station->publisher({"/k/all", TestType, transientLocal(0), Flow::Immediate}));
    constexpr std::uint32_t Most = 5000;  // what the library keeps
    for (std::uint32_t i = 1; i <= Most + 3; ++i) static_cast<void>(reported->write(testPayload(100, i)));
    const auto joined = station->rejoin();
    ASSERT_TRUE(joined) << joined.error().text;
    const auto robot = nodeIn(domain);
    Inbox ear;
    const auto received = must(robot->subscribe({"/k/all", TestType, transientLocal(0)}, ear.callback()));
    EXPECT_TRUE(waitUntil([&] { return ear.size() >= Most; }));
    EXPECT_EQ(ear.size(), Most);
}

TEST(Rejoin, SubscriptionsThatComeAndGoMeanwhileHearAllTheSame) {
    const TestDomain domain;
    const auto robot = nodeIn(domain), station = nodeIn(domain);
    const auto reported = must(robot->publisher({"/k/odom", TestType, bestEffort()}));
    std::atomic<bool> done = false;
    std::jthread rejoining([&] {
        for (int i = 0; i < 8; ++i) EXPECT_TRUE(station->rejoin());
        done = true;
    });
    std::deque<Inbox> inboxes;
    std::vector<std::unique_ptr<Subscription>> subscriptions;
    while (!done) {
        Inbox& inbox = inboxes.emplace_back();
        auto one = must(station->subscribe({"/k/odom", TestType, bestEffort()}, inbox.callback()));
        if (inboxes.size() % 2 == 0) subscriptions.push_back(std::move(one));
        if (subscriptions.size() > 20) subscriptions.erase(subscriptions.begin());
    }
    rejoining.join();
    const auto last =
        must(station->subscribe({"/k/odom", TestType, bestEffort()}, inboxes.emplace_back().callback()));
    for (std::size_t i = inboxes.size() - 2; i > inboxes.size() - 12; --i) {
        if (i % 2 == 0) continue;  // gone at once
        EXPECT_TRUE(waitUntil([&] {
            static_cast<void>(reported->write(testPayload(100, 1)));
            return inboxes[i].size() > 0;
        }));
    }
}

TEST(Reception, AWriterIsOfferedUntilASampleOfItCame) {
    const TestDomain domain;
    const auto robot = nodeIn(domain, {.name = "kurt3d"}), station = nodeIn(domain);
    Inbox ear;
    const auto received = must(station->subscribe({"/k/odom", TestType, bestEffort()}, ear.callback()));
    const auto silent = must(robot->publisher({"/k/odom", TestType, bestEffort()}));
    const auto unlistened = must(robot->publisher({"/k/imu", TestType, bestEffort()}));
    ASSERT_TRUE(waitUntil([&] {
        const DomainReception now = station->reception();
        return now.writers.size() == 1 && now.writers[0].matched;
    }));
    const OfferedWriter offered = station->reception().writers[0];
    EXPECT_EQ(offered.topic, "/k/odom");
    EXPECT_EQ(offered.guid, silent->guid());
    EXPECT_EQ(offered.participant, robot->guid());
    EXPECT_FALSE(offered.received);
    ASSERT_TRUE(waitUntil([&] {
        static_cast<void>(silent->write(testPayload(100, 1)));
        return station->reception().writers[0].received;
    }));
    EXPECT_GE(station->reception().writers[0].seconds, offered.seconds);
}

TEST(Reception, AParticipantWithoutEndpointsIsMute) {
    const TestDomain domain;
    const auto station = nodeIn(domain), other = nodeIn(domain, {.name = "kurt3d"});
    ASSERT_TRUE(waitUntil([&] { return station->reception().mute.size() == 1; }));
    EXPECT_EQ(station->reception().mute[0].participant.name, "kurt3d");
    const auto speaks = must(other->publisher({"/k/odom", TestType, bestEffort()}));
    EXPECT_TRUE(waitUntil([&] { return station->reception().mute.empty(); }));
}

}  // namespace
}  // namespace leitstand::test
