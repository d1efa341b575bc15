#include <algorithm>
#include <cstdio>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/net/radio_link.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int Tries = 10, Streams = 20;

/// What a node of one side says and hears; goes before the node.
struct Side {
    std::unique_ptr<Node> node;
    std::vector<std::unique_ptr<Publisher>> publishers;
    std::vector<std::unique_ptr<Subscription>> subscriptions;

    Side(const TestDomain& domain, const std::string& says, const std::string& receives)
        : node(nodeIn(domain)) {
        for (int i = 0; i < Streams; ++i) {
            const std::string number = "/" + std::to_string(i);
            publishers.push_back(must(node->publisher({says + number, TestType, bestEffort()})));
            subscriptions.push_back(
                must(node->subscribe({receives + number, TestType, bestEffort()}, [](ReceivedSample) {})));
        }
    }
    [[nodiscard]] bool matched() const {
        return std::all_of(publishers.begin(), publishers.end(),
                           [](const auto& one) { return one->matched() == 1; }) &&
               std::all_of(subscriptions.begin(), subscriptions.end(),
                           [](const auto& one) { return one->counts().writers == 1; });
    }
};

/// Two nodes that start with an offset of chance, on both ends of a radio.
double secondsUntilAllMatch(const RadioLink& radio, std::mt19937& random) {
    const TestDomain domain;
    std::optional<Side> robot, station;
    const auto startRobot = [&] {
        const InNamespace there(radio.robots());
        robot.emplace(domain, "/robot", "/station");
    };
    const auto startStation = [&] {
        const InNamespace here(radio.station());
        station.emplace(domain, "/station", "/robot");
    };
    const bool robotFirst = random() % 2 == 0;
    robotFirst ? startRobot() : startStation();
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 500));
    robotFirst ? startStation() : startRobot();
    const auto began = Clock::now();
    EXPECT_TRUE(waitUntil([&] { return robot->matched() && station->matched(); }));
    return std::chrono::duration<double>(Clock::now() - began).count();
}

TEST(DiscoveryRadio, EverythingIsFoundWithin3SecondsWhereOneInTwentyDatagramsIsLost) {
    if (const std::string why = whyNoNodesInNamespaces(); !why.empty()) {
        GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
    }
    RadioConditions air;
    air.bitsPerSecond = 100e6;
    air.delay = 5ms;
    air.mtu = 65'535;
    const RadioLink radio(air);
    std::mt19937 random(9);
    std::vector<double> seconds;
    for (int i = 0; i < Tries; ++i) seconds.push_back(secondsUntilAllMatch(radio, random));
    std::sort(seconds.begin(), seconds.end());
    std::printf("%d tries: all found after %.2f s (median), %.2f s at most\n", Tries, seconds[Tries / 2],
                seconds.back());
    EXPECT_LT(seconds[Tries / 2], 0.5) << "what is lost once costs the second that the library waits";
    EXPECT_LT(seconds.back(), 3.0);
}

}  // namespace
}  // namespace leitstand::test
