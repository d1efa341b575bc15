// What a robot does when the station that drives it hangs or dies, by the simulation's truth.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/robots/held_station.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr double Speed = 0.2;  ///< [m/s]

class StationAndRobot : public testing::Test {
protected:
    StationAndRobot() { writeText(m_folder / "hall.yaml", hallFile("hall")); }
    void startRobot(std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--arena", (m_folder / "hall.yaml").string(), "--interface", "lo"});
        m_robot = std::make_unique<RobotProcess>(m_domain, "kurt3d", std::move(more));
    }
    void startStation(std::vector<std::string> more) {
        m_station = std::make_unique<HeldStation>(m_folder.path(), m_domain, Speed, std::move(more));
    }
    /// The robot drives at speed, by station and truth.
    [[nodiscard]] bool drives() const {
        return m_station->drives() && waitUntil([this] { return m_truth.now() > 0.9 * Speed; }, 10s);
    }
    /// Sends the station @p number while the robot drives; how long the robot drove on [s].
    [[nodiscard]] double standsAfter(int number) {
        EXPECT_TRUE(drives()) << m_station->out() << m_robot->out();
        const Time gone = TrueSpeed::Clock::now();
        m_station->signal(number);
        EXPECT_TRUE(waitUntil([&] { return m_truth.stoodAfter(gone).has_value(); }, 10s));
        std::this_thread::sleep_for(300ms);  // for good: nothing that was on its way moves it again
        return m_truth.stoodAfter(gone).value_or(99.0);
    }

    const TestDomain m_domain;
    const TemporaryFolder m_folder;
    const TrueSpeed m_truth{m_domain, "hall"};
    std::unique_ptr<RobotProcess> m_robot;
    std::unique_ptr<HeldStation> m_station;
};
using GoneStationLatency = StationAndRobot;

class GoneStation : public StationAndRobot, public testing::WithParamInterface<bool> {};

TEST_F(GoneStationLatency, TheRobotStandsWithinThreeTenthsOfASecond) {
    constexpr int Cases = 20;
    startRobot();
    std::vector<double> took;
    while (took.size() < Cases) {
        startStation({"--blind"});
        took.push_back(standsAfter(SIGSTOP));
        m_station->signal(SIGCONT);
        m_station->turn();
        took.push_back(standsAfter(SIGKILL));
        m_station->wait();
    }
    std::sort(took.begin(), took.end());
    for (const double seconds : took) std::printf("%.0f ", 1e3 * seconds);
    std::printf("ms until it stands\n");
    EXPECT_LE(took[Cases - 2], 0.3) << "19 of 20";
    EXPECT_LE(took.back(), 0.4) << "always";
}

INSTANTIATE_TEST_SUITE_P(Eyes, GoneStation, testing::Bool(),
                         [](const auto& info) { return info.param ? "WithACamera" : "Blind"; });

TEST_P(GoneStation, WhenItIsBackItsStickMustBeNeutralBeforeTheRobotMovesAgain) {
    startRobot();
    startStation(GetParam() ? std::vector<std::string>{} : std::vector<std::string>{"--blind"});
    for (const auto hang : {300ms, 500ms, 900ms, 1000ms, 1250ms, 1500ms, 2000ms, 2500ms, 4000ms, 10000ms}) {
        ASSERT_TRUE(drives()) << m_station->out() << m_robot->out();
        m_station->signal(SIGSTOP);
        std::this_thread::sleep_for(hang);  // is what is tested
        const bool stood = m_truth.now() < TrueSpeed::Standing;
        const Time back = TrueSpeed::Clock::now();
        m_station->signal(SIGCONT);
        std::this_thread::sleep_for(1500ms);  // the stick is held
        std::printf("frozen for %lld ms: %.2f m/s at most afterwards\n", static_cast<long long>(hang.count()),
                    m_truth.fastestSince(back));
        if (hang >= 500ms) {
            EXPECT_TRUE(stood) << hang.count();
        }
        if (hang >= 900ms) {
            EXPECT_LT(m_truth.fastestSince(back), TrueSpeed::Standing) << hang.count() << " ms";
        }
        m_station->turn();
    }
}

}  // namespace
}  // namespace leitstand::test
