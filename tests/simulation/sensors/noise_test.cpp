#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/schedule.h"

namespace leitstand::simulation {
namespace {

using namespace std::chrono_literals;
constexpr Time Start{std::chrono::seconds(1'000'000)};

TEST(Noise, IsTheSameForTheSameSeedAndNameOnly) {
    Noise a(7, "left"), b(7, "left"), c(7, "right"), d(8, "left");
    for (int i = 0; i < 100; ++i) {
        const auto value = a.bits();
        EXPECT_EQ(value, b.bits());
        EXPECT_NE(value, c.bits());
        EXPECT_NE(value, d.bits());
    }
}

TEST(Noise, HasTheMomentsOfANormalDistribution) {
    Noise noise(1, "moments");
    constexpr int Count = 200'000;
    double sum = 0, squares = 0, quick = 0, quickSquares = 0;
    int beyondTwo = 0;
    for (int i = 0; i < Count; ++i) {
        const double value = noise.normal(), fast = double{noise.quickNormal()};
        sum += value;
        squares += value * value;
        quick += fast;
        quickSquares += fast * fast;
        beyondTwo += std::abs(value) > 2.0 ? 1 : 0;
    }
    EXPECT_NEAR(sum / Count, 0.0, 0.01);
    EXPECT_NEAR(squares / Count, 1.0, 0.02);
    EXPECT_NEAR(quick / Count, 0.0, 0.01);
    EXPECT_NEAR(quickSquares / Count, 1.0, 0.02);
    EXPECT_NEAR(double(beyondTwo) / Count, 0.0455, 0.003);
}

TEST(Schedule, KeepsItsGridHoweverItIsAsked) {
    for (const auto step : {1ms, 7ms, 40ms, 333ms}) {
        Schedule schedule(9.0, Start);
        std::vector<Time> moments;
        for (Time now = Start; now <= Start + 100s; now += step) {
            while (const auto moment = schedule.due(now)) {
                EXPECT_LE(*moment, now);
                EXPECT_LT(now - *moment, step);
                moments.push_back(*moment);
            }
        }
        ASSERT_GE(moments.size(), 897U);
        ASSERT_LE(moments.size(), 901U);
        for (std::size_t i = 0; i < moments.size(); ++i) {
            EXPECT_NEAR(double((moments[i] - Start).count()), double(i) * 1e9 / 9.0, 1.0);
        }
    }
}

TEST(Schedule, ChangesItsRateFromTheLastMomentOn) {
    Schedule schedule(10.0, Start);
    EXPECT_EQ(schedule.due(Start), Start);
    EXPECT_EQ(schedule.due(Start + 100ms), Start + 100ms);
    schedule.setRate(4.0);
    EXPECT_EQ(schedule.due(Start + 349ms), std::nullopt);
    EXPECT_EQ(schedule.due(Start + 350ms), Start + 350ms);
    schedule.setRate(-1.0);
    EXPECT_EQ(schedule.rate(), 4.0);
}

TEST(Schedule, LeavesOutWhatIsLongPast) {
    Schedule schedule(10.0, Start);
    const auto first = schedule.due(Start + 60s);
    ASSERT_TRUE(first);
    EXPECT_EQ(*first, Start + 59s);
    EXPECT_EQ(schedule.newest(Start + 60s), Start + 60s);
    EXPECT_EQ(schedule.newest(Start + 60s), std::nullopt);
}

}  // namespace
}  // namespace leitstand::simulation
