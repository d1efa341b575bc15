// What a robot does when the station that drives it hangs or dies, by the simulation's truth.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/robots/station_and_robot.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

using GoneStationLatency = StationAndRobot;

class GoneStation : public StationAndRobot, public testing::WithParamInterface<bool> {};

TEST_F(GoneStationLatency, TheRobotStandsWithinThreeTenthsOfASecond) {
    constexpr int Cases = 20;
    startRobot();
    std::vector<double> took;
    while (took.size() < Cases) {
        startStation({"--blind"});
        ASSERT_TRUE(drives()) << words();
        took.push_back(standsAfter(SIGSTOP));
        m_station->signal(SIGCONT);
        m_station->turn();
        ASSERT_TRUE(drives()) << words();
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
        ASSERT_TRUE(drives()) << words();
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
