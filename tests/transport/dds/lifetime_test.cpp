#include <future>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/dds/going_listeners.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// Writes 2000 times a second until destroyed.
class Fountain {
public:
    explicit Fountain(std::unique_ptr<Publisher> publisher)
        : m_publisher(std::move(publisher)), m_thread([this](std::stop_token stop) {
              for (std::uint32_t i = 1; !stop.stop_requested(); ++i) {
                  static_cast<void>(m_publisher->write(testPayload(3000, i)));
                  std::this_thread::sleep_for(500us);
              }
          }) {}

private:
    std::unique_ptr<Publisher> m_publisher;
    std::jthread m_thread;
};

TEST(Lifetime, SubscriptionsGoWhileSamplesCome) {
    const TestDomain domain;
    const auto robot = nodeIn(domain), station = nodeIn(domain);
    const Fountain fountain(must(robot->publisher({"/k/odom", TestType, reliable(10), Flow::Immediate})));
    for (int i = 0; i < 30; ++i) {
        std::atomic<int> calls = 0;
        std::atomic<bool> alive = true;
        auto subscription = must(station->subscribe(
            {"/k/odom", TestType, reliable(10), i % 2 == 0 ? Lane::Small : Lane::Large}, [&](auto) {
                EXPECT_TRUE(alive);
                ++calls;
            }));
        ASSERT_TRUE(waitUntil([&] { return calls > i % 3; }));
        subscription.reset();
        alive = false;
    }
}

TEST(Lifetime, ACallbackMayEndItsOwnSubscriptionAndBeginOthers) {
    const TestDomain domain;
    const auto robot = nodeIn(domain), station = nodeIn(domain);
    const Fountain fountain(must(robot->publisher({"/k/odom", TestType, reliable(10), Flow::Immediate})));
    std::unique_ptr<Subscription> first, second;
    std::atomic<int> calls = 0;
    std::promise<void> ready;
    std::shared_future<void> isReady = ready.get_future().share();
    first = must(station->subscribe({"/k/odom", TestType, reliable(10)}, [&](auto) {
        isReady.wait();
        EXPECT_NE(first, nullptr);  // called at most once
        second = must(station->subscribe({"/k/odom", TestType, reliable(10)}, [&](auto) { ++calls; }));
        first.reset();
    }));
    ready.set_value();
    ASSERT_TRUE(waitUntil([&] { return calls > 10; }));
}

TEST(Lifetime, TheNodeGoesWhileSamplesComeAndGo) {
    const TestDomain domain;
    const auto robot = nodeIn(domain);
    const Fountain fountain(must(robot->publisher({"/k/odom", TestType, reliable(10), Flow::Immediate})));
    for (int i = 0; i < 10; ++i) {
        auto station = nodeIn(domain);
        std::atomic<int> calls = 0;
        station->onDiscovery([node = station.get()] { static_cast<void>(node->endpoints()); });
        const auto small =
            must(station->subscribe({"/k/odom", TestType, reliable(10)}, [&](auto) { ++calls; }));
        auto large = must(
            station->subscribe({"/k/odom", TestType, bestEffort(), Lane::Large}, [&](auto) { ++calls; }));
        const Fountain own(must(station->publisher({"/s/own", TestType, reliable(5), Flow::Scans})));
        ASSERT_TRUE(waitUntil([&] { return calls > 3; }));
        std::jthread elsewhere([&large] { large.reset(); });
        station.reset();
        const int afterwards = calls;
        EXPECT_EQ(calls, afterwards);
    }
}

TEST(Lifetime, WhoWritesOutlivesThatTheLastOneWhoHearsGoes) {
    const TestDomain domain;
    const auto robot = nodeIn(domain), station = nodeIn(domain);
    for (const std::string& warning : robot->warnings())
        EXPECT_EQ(warning.find("Fast DDS"), std::string::npos) << warning;
    for (const int depth : {1, 100}) expectOutlivesItsListeners(*robot, *station, 25, depth);
}

TEST(Lifetime, EndingASubscriptionWaitsForItsCallback) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    const auto publisher = must(node->publisher({"/k/odom", TestType, transientLocal(1)}));
    ASSERT_TRUE(publisher->write(testPayload(10, 1)));
    std::promise<void> entered, leave;
    std::atomic<bool> left = false;
    auto subscription = must(node->subscribe({"/k/odom", TestType, transientLocal(1)}, [&](auto) {
        entered.set_value();
        leave.get_future().wait();
        left = true;
    }));
    entered.get_future().wait();
    auto ending = std::async(std::launch::async, [&] { subscription.reset(); });
    EXPECT_EQ(ending.wait_for(50ms), std::future_status::timeout);
    leave.set_value();
    ending.wait();
    EXPECT_TRUE(left);
}

TEST(Lifetime, WaitingForAcknowledgmentsDoesNotHoldUpTheEnd) {
    const TestDomain domain;
    auto robot = nodeIn(domain);
    const auto station = nodeIn(domain);
    const auto listening = must(station->subscribe({"/k/odom", TestType, reliable(1)}, [](auto) {}));
    const auto publisher = must(robot->publisher({"/k/odom", TestType, reliable(1)}));
    auto waiting = std::async(std::launch::async, [&] {
        bool all = true;
        while (all) {
            if (!publisher->write(testPayload(10, 1))) return false;
            all = publisher->waitForAcknowledgments(10s);
        }
        return all;
    });
    ASSERT_TRUE(waitUntil([&] { return listening->counts().samples > 5; }));
    robot.reset();
    EXPECT_FALSE(waiting.get());
}

}  // namespace
}  // namespace leitstand::test
