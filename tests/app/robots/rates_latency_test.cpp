#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/robots/robot_process.h"
#include "tests/support/process.h"
#include "tests/transport/link/link_station.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto Window = 10s;
constexpr int Attempts = 3;  ///< something else may run on this computer

struct Rate {
    std::string topic;
    double nominal;  ///< [Hz]
};

const std::vector<Rate> OfKurt3d = {
    {"/kurt3d/points", 10},
    {"/kurt3d/odom", 20},
    {"/kurt3d/imu", 20},
    {"/kurt3d/joint_states", 20},
    {"/kurt3d/tf", 40},
    {"/kurt3d/left/image/compressed", 10},
    {"/kurt3d/left/camera_info", 10},
    {"/kurt3d/right/image/compressed", 10},
    {"/kurt3d/right/camera_info", 10},
    {"/kurt3d/ir/image/compressed", 9},
    {"/kurt3d/ir/camera_info", 9},
    {"/kurt3d/co2", 1},
    {"/kurt3d/battery_state", 1},
};
const std::vector<Rate> OfCrawler = {
    {"/crawler/scan", 10},
    {"/crawler/odom", 20},
    {"/crawler/imu", 20},
    {"/crawler/joint_states", 20},
    {"/crawler/tf", 20},
    {"/crawler/omni/image/compressed", 6},
    {"/crawler/omni/camera_info", 6},
    {"/crawler/battery_state", 1},
};

/// Samples in a window of time, by their arrival.
struct Count {
    std::map<std::string, std::size_t> before, after;
    double seconds = 0.0;
    double processor = 0.0;  ///< of both robots [s]

    [[nodiscard]] double rate(const std::string& topic) const {
        return static_cast<double>(after.at(topic) - before.at(topic)) / seconds;
    }
};

/// Within 5 %, and a sample more or less.
bool held(const Count& count, const Rate& rate) {
    return std::abs(count.rate(rate.topic) - rate.nominal) <= 0.05 * rate.nominal + 1.0 / count.seconds;
}

class RobotsLatency : public testing::Test {
protected:
    Count measure() {
        Count count;
        const auto all = [&](std::map<std::string, std::size_t>& counts) {
            for (const Rate& rate : OfKurt3d) counts[rate.topic] = m_kurt3dSaid.count(rate.topic);
            for (const Rate& rate : OfCrawler) counts[rate.topic] = m_crawlerSaid.count(rate.topic);
        };
        const auto used = [&] { return secondsUsedBy(m_kurt3d.id()) + secondsUsedBy(m_crawler.id()); };
        const auto begin = Clock::now();
        const double before = used();
        all(count.before);
        std::this_thread::sleep_until(begin + Window);
        all(count.after);
        count.processor = used() - before;
        count.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        return count;
    }
    const TestDomain m_domain;
    std::unique_ptr<Node> m_node = nodeIn(m_domain);
    RobotListener m_kurt3dSaid{*m_node, shippedRobot("kurt3d")},
        m_crawlerSaid{*m_node, shippedRobot("crawler")};
    RobotProcess m_kurt3d{m_domain, "kurt3d", {"--arena", "yellow", "--seed", "7"}},
        m_crawler{m_domain, "crawler", {"--arena", "yellow", "--seed", "7"}};
};

TEST_F(RobotsLatency, BothInRealTimeHoldAllTheirRatesWithinOneCore) {
    std::vector<Rate> rates = OfKurt3d;
    rates.insert(rates.end(), OfCrawler.begin(), OfCrawler.end());
    for (const Rate& rate : OfKurt3d) ASSERT_TRUE(m_kurt3dSaid.receives(rate.topic, 2)) << rate.topic;
    for (const Rate& rate : OfCrawler) ASSERT_TRUE(m_crawlerSaid.receives(rate.topic, 2)) << rate.topic;
    Count count;
    for (int attempt = 0; attempt < Attempts; ++attempt) {
        count = measure();
        if (std::all_of(rates.begin(), rates.end(), [&](const Rate& rate) { return held(count, rate); }))
            break;
    }
    for (const Rate& rate : rates) {
        std::printf("%-32s %5.2f Hz of %2.0f\n", rate.topic.c_str(), count.rate(rate.topic), rate.nominal);
        EXPECT_TRUE(held(count, rate)) << rate.topic << ": " << count.rate(rate.topic) << " Hz";
    }
    std::printf("both processes: %.2f of a core\n", count.processor / count.seconds);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(count.processor / count.seconds, 1.5) << "one core of a usual computer, and some are slower";
#endif
    EXPECT_THAT(m_kurt3dSaid.errors(), testing::IsEmpty());
    EXPECT_THAT(m_crawlerSaid.errors(), testing::IsEmpty());
}

// Stations judge a link by what comes steadily: nothing may fail while a robot comes into being.
TEST(RobotLinkLatency, FromTheFirstSecondOnItIsConnected) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    LinkStation kurt3d(*node, shippedRobot("kurt3d")), crawler(*node, shippedRobot("crawler"));
    const RobotProcess first(domain, "kurt3d", {"--arena", "yellow", "--seed", "7"}),
        second(domain, "crawler", {"--arena", "yellow", "--seed", "7"});
    ASSERT_TRUE(kurt3d.hearsPongs(16) && crawler.hearsPongs(16)) << "some eight seconds";
    for (const LinkStation* station : {&kurt3d, &crawler}) {
        const LinkStatus status = station->status();
        EXPECT_THAT(station->states(), testing::Not(testing::Contains(LinkState::Degraded)))
            << toString(status.reasons);
        EXPECT_EQ(status.state, LinkState::Connected);
        EXPECT_EQ(status.reconnects, 0);
        for (const StreamStatus& stream : status.streams) {
            EXPECT_FALSE(stream.stale) << stream.topic;
        }
        ASSERT_TRUE(status.clock);
        std::printf("%s: %.2f Mbit/s, round trip %.1f ms\n", status.robot.c_str(), status.megabitsPerSecond,
                    status.roundTrip ? 1e3 * status.roundTrip->median : 0.0);
    }
}

}  // namespace
}  // namespace leitstand::test
