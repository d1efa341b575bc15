#include "app/services/log/replay/replay_pace.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

Time at(std::int64_t count) {
    return Time(nanoseconds(count));
}
constexpr std::int64_t Begin = 1'767'225'600'000'000'000;  // 2026
constexpr auto Least = std::numeric_limits<std::int64_t>::min(),
               Most = std::numeric_limits<std::int64_t>::max();

TEST(ReplayPace, WaitsAsTheLogDid) {
    ReplayPace pace;
    EXPECT_EQ(pace.waitBefore(at(Begin), true), 0ns);
    EXPECT_EQ(pace.waitBefore(at(Begin + 40), false), 40ns);
    EXPECT_EQ(pace.waitBefore(at(Begin + 10), false), 0ns) << "it goes back a little";
    EXPECT_EQ(pace.waitBefore(at(Begin + 50), false), 10ns) << "counted from the latest";
    EXPECT_EQ(pace.waitBefore(Time(at(Begin + 50)) + 20min, false), 20min)
        << "silence is part of the mission";
    EXPECT_EQ(pace.waitBefore(Time(at(Begin + 50)) + 30min, true), 1s) << "the station was off";
}

TEST(ReplayPace, TimesThatMakeNoSenseCostASecond) {
    for (const std::int64_t wild : {Most, Most - 1, Least, std::int64_t{0}, std::int64_t{-1}}) {
        ReplayPace pace;
        EXPECT_EQ(pace.waitBefore(at(Begin), true), 0ns);
        EXPECT_LE(pace.waitBefore(at(wild), false), 1s) << wild;
        EXPECT_LE(pace.waitBefore(at(Begin + 5), false), 1s) << wild;
        EXPECT_EQ(pace.waitBefore(at(Begin + 12), false), 7ns) << "and then it goes on as before";
    }
    ReplayPace first;
    EXPECT_EQ(first.waitBefore(at(Most), true), 0ns);
    EXPECT_EQ(first.waitBefore(at(Least), false), 0ns);
    EXPECT_EQ(first.waitBefore(at(Most), false), 1s);
}

TEST(ReplayPace, NeverWaitsLongerThanAnHourNorBackwards) {
    std::mt19937_64 random(1);
    ReplayPace pace;
    for (int i = 0; i < 100'000; ++i) {
        const auto near = static_cast<std::int64_t>(random() % 10'000'000'000'000);
        const auto wait = pace.waitBefore(
            i % 3 == 0 ? at(static_cast<std::int64_t>(random())) : at(Begin + near), random() % 100 == 0);
        ASSERT_GE(wait, 0ns);
        ASSERT_LE(wait, ReplayPace::MostSilence);
    }
}

}  // namespace
}  // namespace leitstand
