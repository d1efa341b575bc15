#include "core/mission/state/mission_clock.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

const Time Noon{std::chrono::hours(12)};

TEST(MissionClockTest, StandsAtZeroUntilAStationStartsIt) {
    const MissionClock clock = clockAt(std::nullopt, Noon);
    EXPECT_FALSE(clock.running);
    EXPECT_EQ(clock.elapsed, seconds(0));
    EXPECT_FALSE(clock.left);
}

TEST(MissionClockTest, GoesOnWhileNoStationRuns) {
    const ClockSample reported = clockRun({}, true, Noon, "station");
    EXPECT_EQ(clockAt(reported, Noon + minutes(3)).elapsed, minutes(3));
}

TEST(MissionClockTest, StandsWhileItIsHeldAndGoesOnFromThere) {
    const ClockSample started = clockRun({}, true, Noon, "station");
    const ClockSample held =
        clockRun(clockAt(started, Noon + minutes(2)), false, Noon + minutes(2), "station");
    EXPECT_EQ(clockAt(held, Noon + minutes(9)).elapsed, minutes(2));
    const ClockSample on = clockRun(clockAt(held, Noon + minutes(9)), true, Noon + minutes(9), "station");
    EXPECT_EQ(clockAt(on, Noon + minutes(10)).elapsed, minutes(3));
}

TEST(MissionClockTest, CountsDownFromItsLengthAndBeyond) {
    const ClockSample started = clockRun({}, true, Noon, "station");
    const ClockSample limited = clockLimited(clockAt(started, Noon), minutes(20), Noon, "station");
    EXPECT_EQ(clockAt(limited, Noon + minutes(19)).left, minutes(1));
    EXPECT_EQ(clockAt(limited, Noon + minutes(21)).left, minutes(-1));
    const ClockSample free = clockLimited(clockAt(limited, Noon), minutes(-4), Noon, "station");
    EXPECT_FALSE(clockAt(free, Noon).left);
}

TEST(MissionClockTest, TheRulesLengthCountsOnlyWhereNobodySetOne) {
    const ClockSample started = clockRun({}, true, Noon, "station");
    const MissionClock ruled = withLength(clockAt(started, Noon + minutes(5)), 23.0);
    EXPECT_EQ(ruled.limit, minutes(23));
    EXPECT_EQ(ruled.left, minutes(18));
    EXPECT_FALSE(withLength(clockAt(started, Noon), 0.0).left) << "the rules do not tell";
    const ClockSample limited = clockLimited(clockAt(started, Noon), minutes(20), Noon, "station");
    EXPECT_EQ(withLength(clockAt(limited, Noon + minutes(5)), 23.0).left, minutes(15));
}

TEST(MissionClockTest, BeginsAnewAndKeepsItsLength) {
    const ClockSample limited = clockLimited({.running = true}, minutes(20), Noon, "station");
    const ClockSample again = clockReset(clockAt(limited, Noon + minutes(5)), Noon + minutes(5), "station");
    const MissionClock clock = clockAt(again, Noon + minutes(6));
    EXPECT_TRUE(clock.running);
    EXPECT_EQ(clock.elapsed, minutes(1));
    EXPECT_EQ(clock.limit, minutes(20));
}

TEST(MissionClockTest, DoesNotRunBackWhenTheComputersClockIsSetBack) {
    const ClockSample started = clockRun({.elapsed = minutes(4)}, true, Noon, "station");
    EXPECT_EQ(clockAt(started, Noon - minutes(1)).elapsed, minutes(4));
}

}  // namespace
}  // namespace leitstand::test
