// What a thin link really carries, measured on the wire: all packets, both ways.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "tests/app/robots/listening_station.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/net/radio_link.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class ThinLinkOnTheWire : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string why = whyNoNamespaces(); !why.empty())
            GTEST_SKIP() << "SKIPPED: a network of its own needs namespaces and TUN: " << why;
        m_radio.emplace(RadioConditions{.bitsPerSecond = 100e6, .delay = 2ms, .loss = 0.0});
        {
            const InNamespace there(m_radio->robots());
            for (const char* kind : {"kurt3d", "crawler"}) {
                m_robots.push_back(std::make_unique<RobotProcess>(
                    m_domain, kind, std::vector<std::string>{"--arena", "yellow", "--seed", "7"}));
            }
            m_truth.emplace(m_domain, "yellow_7", "");
        }
    }
    void open(std::vector<std::string> more) {
        const InNamespace here(m_radio->station());
        m_station = std::make_unique<ListeningStation>(m_folder / "station", m_domain, std::move(more));
        ASSERT_TRUE(waitUntil(
            [&] {
                return m_station->receives({"/kurt3d/odom", "/crawler/odom", "/kurt3d/points"});
            },
            60s))
            << m_station->out();
    }
    /// How far @p robot truly was from where it began, at most [m].
    [[nodiscard]] double farthest(const std::string& robot) const {
        const auto poses = m_truth->listener().all<OdometrySample>(m_truth->topic(robot));
        double most = 0.0;
        for (const OdometrySample& one : poses)
            most = std::max(most,
                            (one.baseInOdom.translation() - poses.front().baseInOdom.translation()).norm());
        return most;
    }
    /// Mbit/s of each second.
    [[nodiscard]] std::vector<double> measure(int seconds) const {
        std::vector<double> all;
        auto next = Clock::now();
        for (std::uint64_t before = m_radio->bytes(); seconds > 0; --seconds) {
            std::this_thread::sleep_until(next += 1s);  // is what is measured
            const std::uint64_t now = m_radio->bytes();
            all.push_back(8e-6 * static_cast<double>(now - before));
            before = now;
        }
        return all;
    }

    const TestDomain m_domain;
    const TemporaryFolder m_folder;
    std::optional<RadioLink> m_radio;
    std::vector<std::unique_ptr<RobotProcess>> m_robots;
    std::unique_ptr<ListeningStation> m_station;
    std::optional<Truth> m_truth;
};

TEST_F(ThinLinkOnTheWire, StaysWithinItsBudgetWhileBothRobotsExplore) {
    constexpr double Budget = 2.0;  // [Mbit/s], as it is unless told otherwise
    constexpr int Window = 10;      // [s]
    open({"--explore", "--thin", std::to_string(Budget)});
    std::this_thread::sleep_for(10s);  // to settle
    const std::vector<double> seconds = measure(30);
    double worst = 0.0;
    for (std::size_t i = 0; i + Window <= seconds.size(); ++i) {
        double sum = 0.0;
        for (std::size_t k = i; k < i + Window; ++k) sum += seconds[k] / Window;
        worst = std::max(worst, sum);
    }
    for (const double one : seconds) std::printf("%.2f ", one);
    std::printf("Mbit/s; at most %.2f over %d s\n", worst, Window);
    EXPECT_LE(worst, Budget);
    for (const char* robot : {"kurt3d", "crawler"}) {
        std::printf("%s was up to %.1f m from its start\n", robot, farthest(robot));
        EXPECT_GT(farthest(robot), 0.5) << robot << " explores over a thin link, too";
    }
    for (const auto& [topic, stream] : m_station->streams())
        std::printf("%-34s %5.1f Hz\n", topic.c_str(), stream.rate);
    EXPECT_GT(m_station->streams().at("/kurt3d/odom").rate, 10.0) << "odometry is never touched";
    EXPECT_GT(m_station->streams().at("/kurt3d/points").rate, 0.8) << "scans of the selected robot stay";
    EXPECT_GT(m_station->streams().at("/kurt3d/left/image/compressed").rate, 0.5) << "and one camera";
}

}  // namespace
}  // namespace leitstand::test
