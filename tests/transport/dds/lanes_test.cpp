#include <algorithm>
#include <cstdio>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/latency.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

// A consumer of scans that takes 400 ms for each must not hold up odometry at 100 Hz.
TEST(LanesLatency, ASlowConsumerOfScansDelaysNoOdometry) {
    const TestDomain domain;
    const std::string number = std::to_string(domain.number());
    const auto station = nodeIn(domain);
    std::atomic<int> scans = 0;
    const auto scanning =
        must(station->subscribe({"/k/points", TestType, reliable(600), Lane::Large}, [&](auto) {
            ++scans;
            std::this_thread::sleep_for(400ms);
        }));
    std::mutex mutex;
    std::vector<double> delays;
    const auto listening =
        must(station->subscribe({"/k/odom", TestType, bestEffort()}, [&](ReceivedSample sample) {
            const std::chrono::duration<double, std::milli> delay =
                std::chrono::system_clock::now() - sample.sourceTime;
            const std::scoped_lock lock(mutex);
            delays.push_back(delay.count());
        }));
    const ChildProcess talker(program("dds_peer"), {"talk", number, "/k/odom", "reliable=0", "period=10"});
    const ChildProcess scanner(program("dds_peer"), {"talk", number, "/k/points", "size=50000", "period=100",
                                                     "depth=600", "flow=2", "limit=0"});
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(mutex);
        return delays.size() >= 400;
    }));
    const std::scoped_lock lock(mutex);
    const double p99 = quantile(delays, 0.99);
    std::printf(
        "odometry beside a consumer that takes 400 ms a scan: p50 %.2f ms, p99 %.2f ms, worst %.2f ms\n",
        quantile(delays, 0.5), p99, quantile(delays, 1.0));
    EXPECT_LT(p99, 50.0);
    EXPECT_GT(scans, 2);
    EXPECT_LT(scans, 20);
}

TEST(Lanes, EachIsOneThreadOfItsOwn) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    std::mutex mutex;
    std::map<std::string, std::thread::id> threads;
    std::vector<std::unique_ptr<Subscription>> subscriptions;
    std::vector<std::unique_ptr<Publisher>> publishers;
    for (const auto& [topic, lane] :
         {std::pair{"/a", Lane::Small}, {"/b", Lane::Small}, {"/c", Lane::Large}}) {
        publishers.push_back(must(node->publisher({topic, TestType, transientLocal(1)})));
        ASSERT_TRUE(publishers.back()->write(testPayload(10, 1)));
        subscriptions.push_back(
            must(node->subscribe({topic, TestType, transientLocal(1), lane}, [&](auto sample) {
                const std::scoped_lock lock(mutex);
                threads[sample.event.topic] = std::this_thread::get_id();
            })));
    }
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(mutex);
        return threads.size() == 3;
    }));
    EXPECT_EQ(threads["/a"], threads["/b"]);
    EXPECT_NE(threads["/a"], threads["/c"]);
}

TEST(Lanes, AFloodOnOneTopicLeavesTheOthersTheirTurn) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    const auto flood = must(node->publisher({"/flood", TestType, transientLocal(3000), Flow::Immediate}));
    for (std::uint32_t i = 0; i < 3000; ++i) ASSERT_TRUE(flood->write(testPayload(20, i)));
    const auto other = must(node->publisher({"/other", TestType, transientLocal(1), Flow::Immediate}));
    ASSERT_TRUE(other->write(testPayload(20, 1)));
    std::atomic<bool> seen = false;
    std::atomic<int> after = 0;
    const auto flooded = must(node->subscribe({"/flood", TestType, transientLocal(3000)}, [&](auto) {
        std::this_thread::sleep_for(1ms);
        if (seen) ++after;
    }));
    const auto listening =
        must(node->subscribe({"/other", TestType, transientLocal(1)}, [&](auto) { seen = true; }));
    ASSERT_TRUE(waitUntil([&] { return seen && after > 0; }));
}

}  // namespace
}  // namespace leitstand::test
