#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "core/robot/link/round_trips.h"
#include "core/robot/link/stream_monitor.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

SteadyTime steady(double seconds) {
    return SteadyTime(1000s + nanoseconds(std::llround(1e9 * seconds)));
}
Time day(double seconds) {
    return Time(1'700'000'000s + nanoseconds(std::llround(1e9 * seconds)));
}
StreamArrival arrival(std::uint64_t sequence, double written, double received, std::uint8_t writer = 1) {
    return {1000, {writer}, sequence, day(written), day(received)};
}

/// @p count samples at @p rate from @p begin, numbered from @p first.
void feed(StreamMonitor& stream, double begin, double rate, int count, std::uint64_t first = 1,
          std::uint8_t writer = 1) {
    for (int i = 0; i < count; ++i) {
        const double t = begin + i / rate;
        stream.add(arrival(first + static_cast<std::uint64_t>(i), t, t + 0.01, writer), steady(t + 0.01));
    }
}

TEST(StreamMonitor, TellsRateAgeAndBandwidth) {
    for (const double rate : {0.5, 1.0, 5.0, 20.0, 50.0, 400.0}) {
        StreamMonitor stream;
        feed(stream, 0.0, rate, static_cast<int>(20.0 * rate));
        const auto figures = stream.figures(steady(20.0));
        EXPECT_NEAR(figures.rate, rate, 0.02 * rate);
        EXPECT_NEAR(figures.megabitsPerSecond, rate * 0.008, 0.02 * rate * 0.008);
        EXPECT_NEAR(figures.age, std::max(0.0, 1.0 / rate - 0.01), 1e-6);
        EXPECT_EQ(figures.lossRatio, 0.0);
        EXPECT_NEAR(*stream.interval(), 1.0 / rate, 1e-3 / rate);
        EXPECT_EQ(figures.transit, nanoseconds(10ms));
    }
}

TEST(StreamMonitor, ARateFallsWhenNothingComes) {
    StreamMonitor stream;
    feed(stream, 0.0, 20.0, 400);
    double before = stream.figures(steady(20.0)).rate;
    for (double t = 20.2; t < 26.0; t += 0.1) {
        const double now = stream.figures(steady(t)).rate;
        EXPECT_LE(now, before + 1e-9);
        before = now;
    }
    EXPECT_EQ(before, 0.0);
    EXPECT_EQ(stream.figures(steady(26.0)).megabitsPerSecond, 0.0);
}

TEST(StreamMonitor, GapsInTheNumbersAreLosses) {
    StreamMonitor stream;
    std::mt19937 random(1);
    std::uint64_t lost = 0;
    for (int i = 0; i < 2000; ++i) {
        if (i > 0 && i < 1999 && random() % 8 == 0) {
            ++lost;
            continue;
        }
        stream.add(arrival(static_cast<std::uint64_t>(i + 1), 0.05 * i, 0.05 * i), steady(0.05 * i));
    }
    EXPECT_EQ(stream.lost(), lost);
    EXPECT_EQ(stream.samples(), 2000 - lost);
    const auto figures = stream.figures(steady(100.0));
    EXPECT_NEAR(figures.lossRatio, 0.125, 0.06);
    EXPECT_NEAR(static_cast<double>(figures.lossBasis), 200.0, 12.0);
    EXPECT_NEAR(*stream.interval(), 0.05, 1e-6);  // as it is sent, whatever gets lost
}

TEST(StreamMonitor, ARestartedWriterAndALateJoinerLoseNothing) {
    StreamMonitor stream;
    feed(stream, 0.0, 20.0, 100, 5000);
    feed(stream, 5.0, 20.0, 100, 1, 2);
    feed(stream, 10.0, 20.0, 100, 70, 3);
    EXPECT_EQ(stream.lost(), 0U);
    EXPECT_EQ(stream.samples(), 300U);
}

TEST(StreamMonitor, RepeatsOfATransientWriterAreNoLoss) {
    StreamMonitor stream;
    feed(stream, 0.0, 1.0, 10, 1);
    feed(stream, 20.0, 100.0, 10, 1);  // all again, as it is found again
    feed(stream, 30.0, 1.0, 10, 11);
    EXPECT_EQ(stream.lost(), 0U);
}

TEST(StreamMonitor, SeveralWritersOfATopicAreToldApart) {
    StreamMonitor stream;
    for (int i = 0; i < 100; ++i) {
        for (std::uint8_t writer = 1; writer <= StreamMonitor::Writers; ++writer) {
            stream.add(arrival(static_cast<std::uint64_t>(i) + 100U * writer, 0.1 * i, 0.1 * i, writer),
                       steady(0.1 * i));
        }
    }
    EXPECT_EQ(stream.lost(), 0U);
}

TEST(StreamMonitor, ANumberFromNowhereIsNoLoss) {
    StreamMonitor stream;
    feed(stream, 0.0, 20.0, 20);
    stream.add(arrival(~std::uint64_t{0}, 1.0, 1.0), steady(1.0));
    stream.add(arrival(0, 1.1, 1.1), steady(1.1));
    EXPECT_LT(stream.lost(), 1000U);
}

TEST(StreamMonitor, ABurstAfterAGapDoesNotBendTheLearnedRate) {
    StreamMonitor stream;
    feed(stream, 0.0, 10.0, 100);
    for (int i = 0; i < 300; ++i) {  // what was held back for 30 s comes within a third of one
        const double written = 10.0 + 0.1 * i;
        stream.add(arrival(101 + static_cast<std::uint64_t>(i), written, 40.0 + 0.001 * i),
                   steady(40.0 + 0.001 * i));
    }
    EXPECT_EQ(stream.lost(), 0U);
    EXPECT_NEAR(*stream.interval(), 0.1, 1e-6);
}

TEST(StreamMonitor, ASlowerRateIsLearnedAndAPauseIsNot) {
    StreamMonitor stream;
    feed(stream, 0.0, 20.0, 100, 1);
    feed(stream, 35.0, 20.0, 100, 101);  // 30 s of pause
    EXPECT_NEAR(*stream.interval(), 0.05, 1e-3);
    feed(stream, 40.0, 0.5, 10, 201);
    EXPECT_NEAR(*stream.interval(), 2.0, 0.1);
}

TEST(StreamMonitor, WithoutNumbersAndTimesItCountsArrivals) {
    StreamMonitor stream;
    for (int i = 0; i < 100; ++i) stream.add({10, {}, 0, {}, day(0.1 * i)}, steady(0.1 * i));
    EXPECT_NEAR(*stream.interval(), 0.1, 1e-6);
    EXPECT_NEAR(stream.figures(steady(10.0)).rate, 10.0, 0.1);
    EXPECT_FALSE(stream.figures(steady(10.0)).transit);
}

TEST(RoundTrips, TellMedianLastAndWhatIsUnanswered) {
    RoundTrips trips;
    EXPECT_FALSE(trips.status(steady(0.0)));
    for (std::uint64_t i = 0; i < 12; ++i) {
        const double t = 0.5 * static_cast<double>(i);
        trips.sent(100 + i, day(t), steady(t));
        if (i % 4 == 3) continue;
        const double took = i == 10 ? 2.0 : 0.04;
        EXPECT_TRUE(trips.answered(100 + i, day(t), 5ms, steady(t + took + 0.005)));
    }
    const auto status = *trips.status(steady(8.0));
    EXPECT_NEAR(status.median, 0.04, 1e-6);
    EXPECT_NEAR(status.last, 2.0, 1e-6);
    EXPECT_NEAR(status.unanswered, 0.25, 1e-6);
    EXPECT_NEAR(status.age, 8.0 - 7.005, 1e-6);
}

TEST(RoundTrips, OnlyFirstAnswersToOwnPingsCount) {
    RoundTrips trips;
    trips.sent(1, day(0.0), steady(0.0));
    EXPECT_FALSE(trips.answered(2, day(0.0), {}, steady(0.1)));
    EXPECT_FALSE(trips.answered(1, day(0.5), {}, steady(0.1)));  // of a station before this one
    EXPECT_TRUE(trips.answered(1, day(0.0), {}, steady(0.1)));
    EXPECT_FALSE(trips.answered(1, day(0.0), {}, steady(0.2)));
    for (std::uint64_t i = 2; i < 50; ++i) trips.sent(i, day(1.0), steady(1.0));
    EXPECT_FALSE(trips.answered(2, day(1.0), {}, steady(1.1)));  // too long ago
}

TEST(RoundTrips, WaitingBeginsWhenAnswersStop) {
    RoundTrips trips;
    trips.sent(1, day(0.0), steady(0.0));
    EXPECT_EQ(trips.waiting(steady(5.0)), 0.0);  // it may never answer
    EXPECT_TRUE(trips.answered(1, day(0.0), {}, steady(5.0)));
    EXPECT_EQ(trips.waiting(steady(9.0)), 0.0);  // nothing was asked
    trips.sent(2, day(9.0), steady(9.0));
    EXPECT_NEAR(trips.waiting(steady(9.5)), 4.5, 1e-6);
}

TEST(RoundTrips, ARobotCannotClaimToHaveHeldAPingLongerThanItWasAway) {
    RoundTrips trips;
    trips.sent(1, day(0.0), steady(0.0));
    EXPECT_TRUE(trips.answered(1, day(0.0), 10h, steady(0.1)));
    EXPECT_EQ(trips.status(steady(0.2))->last, 0.0);
}

}  // namespace
}  // namespace leitstand::test
