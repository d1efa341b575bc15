#include <cmath>
#include <cstdio>
#include <optional>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/net/radio_link.h"
#include "tests/support/places.h"
#include "tests/transport/link/link_robot.h"
#include "tests/transport/link/link_station.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

double toSeconds(std::chrono::nanoseconds duration) {
    return std::chrono::duration<double>(duration).count();
}

/// A link of 10 Mbit/s, 20 ms each way, 5 % loss.
class LinkOverRadio : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string why = whyNoNamespaces(); !why.empty())
            GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
        m_radio.emplace();
        {
            const InNamespace there(m_radio->robots());
            // A process of its own: Fast DDS 3 looks at the interfaces of a process once, for all its
            // namespaces.
            m_kurt = std::make_unique<ChildProcess>(
                program("control_peer"),
                std::vector<std::string>{"pinged", std::to_string(m_domain.number()), "5"});
        }
        const InNamespace here(m_radio->station());
        m_node = nodeIn(m_domain);
        m_station = std::make_unique<LinkStation>(*m_node, m_description);
    }
    const TestDomain m_domain;
    const RobotDescription m_description = pingableRobot();
    std::optional<RadioLink> m_radio;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<ChildProcess> m_kurt;
    std::unique_ptr<LinkStation> m_station;
};

TEST_F(LinkOverRadio, RoundTripLossAndClockAreMeasured) {
    ASSERT_TRUE(m_station->becomes(LinkState::Connected, 60s));
    ASSERT_TRUE(waitUntil([&] { return m_station->pongs().size() >= 20; }, 60s));
    const LinkStatus link = m_station->status();
    const StreamStatus& odometry = *link.stream("/kurt3d/odom");
    std::printf(
        "round trip %.1f ms (median), clock %.2f ms off 5 s, +- %.1f ms, odometry %.1f Hz, %.1f %% lost\n",
        1e3 * link.roundTrip->median, 1e3 * (toSeconds(link.clock->ahead) - 5.0),
        1e3 * toSeconds(link.clock->uncertainty), odometry.rate, 100.0 * odometry.lossRatio);
    EXPECT_GT(link.roundTrip->median, 0.039);
    EXPECT_LT(link.roundTrip->median, 0.150);
    EXPECT_NEAR(toSeconds(link.clock->ahead), 5.0, 0.020);
    EXPECT_GT(odometry.lost, 0U);
    EXPECT_LT(odometry.lossRatio, 0.15);
}

TEST_F(LinkOverRadio, AfterARadioGapItIsConnectedAgainByItself) {
    ASSERT_TRUE(m_station->becomes(LinkState::Connected, 60s));
    ASSERT_TRUE(waitUntil([&] { return m_station->pongs().size() >= 3; }, 30s));
    m_radio->setOutage(true);
    ASSERT_TRUE(m_station->becomes(LinkState::Lost, 10s));
    ASSERT_TRUE(waitUntil([&] { return m_station->status().silence > 4.0; }, 10s));
    m_radio->setOutage(false);
    const auto back = std::chrono::steady_clock::now();
    ASSERT_TRUE(waitUntil([&] { return m_station->status().state != LinkState::Lost; }, 10s));
    std::printf("no longer lost %.2f s after the radio came back: %s\n",
                toSeconds(std::chrono::steady_clock::now() - back),
                toString(m_station->status().reasons).c_str());
    EXPECT_TRUE(m_station->becomes(LinkState::Connected, 30s));
    EXPECT_EQ(m_station->status().reconnects, 1);
    EXPECT_NEAR(toSeconds(m_station->status().clock->ahead), 5.0, 0.020);
    EXPECT_EQ(m_station->status().clock->steps, 0);
}

}  // namespace
}  // namespace leitstand::test
