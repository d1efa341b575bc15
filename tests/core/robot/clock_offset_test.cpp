#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "core/robot/clock/clock_offset.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

nanoseconds fromSeconds(double seconds) {
    return nanoseconds(std::llround(1e9 * seconds));
}
double toSeconds(nanoseconds duration) {
    return std::chrono::duration<double>(duration).count();
}
/// @p seconds after the tests' station began, on its clock that never steps, and on its clock of the day.
SteadyTime steady(double seconds) {
    return SteadyTime(1000s + fromSeconds(seconds));
}
Time day(double seconds) {
    return Time(1'700'000'000s + fromSeconds(seconds));
}

/// A way through the air: never quicker than @ref least, as late as it likes.
struct Way {
    double least = 0.020, meanJitter = 0.005;  // [s]
    double operator()(std::mt19937& random) const {
        return least + std::exponential_distribution<>(1.0 / meanJitter)(random);
    }
};

/// A robot with a clock of its own, pinged at 2 Hz.
class PingedRobot {
public:
    explicit PingedRobot(unsigned seed) : m_random(seed) {}
    Way there, back;
    double loss = 0.05;
    double clockError = 0.0;  ///< at the beginning [s]
    double drift = 0.0;
    double granularity = 0.0;  ///< its clock is read in steps of [s]
    double held = 0.0002;      ///< [s]

    [[nodiscard]] double aheadAt(double t) const { return clockError + drift * t; }
    [[nodiscard]] Time clockAt(double t) const {
        const double ahead = aheadAt(t);
        if (granularity <= 0.0) return day(t) + fromSeconds(ahead);
        return day(granularity * std::floor((t + ahead) / granularity));
    }
    /// The ping sent at @p t; false when it or its answer was lost.
    bool ping(double t, PingTimes& times, double& arrival) {
        const double thereAt = t + there(m_random), awayAt = thereAt + held;
        arrival = awayAt + back(m_random);
        times = {day(t), clockAt(thereAt), clockAt(awayAt), day(arrival)};
        return std::uniform_real_distribution<>(0.0, 1.0)(m_random) >= loss;
    }

private:
    std::mt19937 m_random;
};

/// Pings @p robot for @p duration seconds from @p begin; @p check is told the time and the error [s] after
/// each answer.
void run(PingedRobot& robot, ClockOffset& clock, double begin, double duration,
         const std::function<void(double t, double error, const ClockStatus&)>& check = {}) {
    for (double t = begin; t < begin + duration; t += 0.5) {
        PingTimes times;
        double arrival = 0.0;
        if (!robot.ping(t, times, arrival)) continue;
        EXPECT_TRUE(clock.ping(times, steady(arrival)));
        const auto status = clock.status(steady(arrival));
        ASSERT_TRUE(status);
        if (check) check(t, toSeconds(status->ahead) - robot.aheadAt(arrival), *status);
    }
}

TEST(ClockOffset, IsUnknownBeforeAnythingCame) {
    EXPECT_FALSE(ClockOffset().status(steady(0.0)));
}

TEST(ClockOffset, OfAClock5SecondsOffIsKnownAfterOnePing) {
    for (const double error : {-5.0, 5.0, 1e8, -1e8}) {
        PingedRobot robot(1);
        robot.clockError = error;
        robot.loss = 0.0;
        ClockOffset clock;
        run(robot, clock, 0.0, 0.5, [](double, double wrong, const ClockStatus& status) {
            EXPECT_LT(std::abs(wrong), 0.020);
            EXPECT_LT(status.uncertainty, 50ms);
            EXPECT_EQ(status.source, ClockSource::Pings);
            EXPECT_EQ(status.steps, 0);
        });
    }
}

TEST(ClockOffset, AsymmetricJitterLossAndDriftAreSeenThrough) {
    PingedRobot robot(2);
    robot.clockError = 5.0;
    robot.drift = 50e-6;
    robot.there.meanJitter = 0.005;
    robot.back.meanJitter = 0.060;
    ClockOffset clock;
    double worst = 0.0, widest = 0.0;
    run(robot, clock, 0.0, 1200.0, [&](double t, double error, const ClockStatus& status) {
        EXPECT_LE(std::abs(error), toSeconds(status.uncertainty)) << "after " << t << " s";
        if (t < 20.0) return;
        worst = std::max(worst, std::abs(error));
        widest = std::max(widest, toSeconds(status.uncertainty));
    });
    EXPECT_LT(worst, 0.010);
    EXPECT_LT(widest, 0.035);
    EXPECT_EQ(clock.status(steady(1200.0))->steps, 0);
    std::printf(
        "offset with 5 ms of jitter there and 60 ms back: worst error %.1f ms, widest bounds %.1f ms\n",
        1e3 * worst, 1e3 * widest);
}

TEST(ClockOffset, AStepIsFollowedWithinThreePingsAndTold) {
    for (const double step : {5.0, -5.0, 0.2, -0.2, 3600.0}) {
        PingedRobot robot(3);
        robot.loss = 0.0;
        robot.clockError = 1.0;
        ClockOffset clock;
        run(robot, clock, 0.0, 60.0);
        robot.clockError += step;
        run(robot, clock, 60.0, 1.5);
        const auto status = *clock.status(steady(61.5));
        EXPECT_NEAR(toSeconds(status.ahead), 1.0 + step, 0.020);
        EXPECT_EQ(status.steps, 1);
        EXPECT_NEAR(toSeconds(status.lastStep), step, 0.030);
        EXPECT_LT(status.stepAge, 1.5);
        run(robot, clock, 61.5, 60.0);
        EXPECT_EQ(clock.status(steady(121.5))->steps, 1);
    }
}

TEST(ClockOffset, AStepOfTheStationsOwnClockIsFollowedToo) {
    PingedRobot robot(4);
    robot.loss = 0.0;
    ClockOffset clock;
    run(robot, clock, 0.0, 30.0);
    for (int i = 0; i < 3; ++i) {  // the day of the station is 7 s on, the steady clock is not
        PingTimes times;
        double arrival = 0.0;
        ASSERT_TRUE(robot.ping(30.0 + 0.5 * i, times, arrival));
        times.sent += 7s;
        times.received += 7s;
        EXPECT_TRUE(clock.ping(times, steady(arrival)));
    }
    EXPECT_NEAR(toSeconds(clock.status(steady(31.5))->ahead), -7.0, 0.020);
    EXPECT_EQ(clock.status(steady(31.5))->steps, 1);
}

TEST(ClockOffset, SingleWrongPingsChangeNothing) {
    PingedRobot robot(5);
    robot.loss = 0.0;
    robot.clockError = -5.0;
    ClockOffset clock;
    std::mt19937 random(6);
    std::uniform_real_distribution<> nonsense(-1000.0, 1000.0);
    for (int i = 0; i < 2000; ++i) {
        PingTimes times;
        double arrival = 0.0;
        ASSERT_TRUE(robot.ping(0.5 * i, times, arrival));
        if (i > 0 && random() % 10 == 0) {
            const nanoseconds wrong = fromSeconds(nonsense(random));
            times.robotReceived += wrong;
            times.robotReplied += wrong;
        }
        clock.ping(times, steady(arrival));
        const auto status = *clock.status(steady(arrival));
        EXPECT_NEAR(toSeconds(status.ahead), -5.0, toSeconds(status.uncertainty));
        EXPECT_EQ(status.steps, 0);
    }
}

TEST(ClockOffset, ASlewedClockIsFollowedWithoutAWord) {
    PingedRobot robot(7);
    robot.loss = 0.0;
    ClockOffset clock;
    run(robot, clock, 0.0, 60.0);
    robot.drift = 500e-6;  // as fast as ntpd moves a clock
    robot.clockError = -500e-6 * 60.0;
    double worst = 0.0;
    run(robot, clock, 60.0, 600.0,
        [&](double, double error, const ClockStatus&) { worst = std::max(worst, std::abs(error)); });
    EXPECT_LT(worst, 0.030);
    EXPECT_EQ(clock.status(steady(660.0))->steps, 0);
}

TEST(ClockOffset, ClocksReadInMillisecondsAreNoContradiction) {
    PingedRobot robot(8);
    robot.granularity = 0.001;
    robot.there = robot.back = {0.0001, 0.0001};
    robot.clockError = 5.0;
    ClockOffset clock;
    double worst = 0.0;
    run(robot, clock, 0.0, 300.0,
        [&](double, double error, const ClockStatus&) { worst = std::max(worst, std::abs(error)); });
    EXPECT_LT(worst, 0.0015);
    EXPECT_EQ(clock.status(steady(300.0))->steps, 0);
}

TEST(ClockOffset, PingsThatContradictThemselvesAreRefused) {
    ClockOffset clock;
    EXPECT_FALSE(clock.ping({day(1.0), day(1.1), day(1.2), day(0.9)}, steady(1.0)));  // back before it left
    EXPECT_FALSE(clock.ping({day(1.0), day(1.2), day(1.1), day(1.3)}, steady(1.3)));  // replied before asked
    EXPECT_FALSE(clock.ping({day(1.0), day(1.0), day(2.0), day(1.3)}, steady(1.3)));  // held too long
    EXPECT_FALSE(clock.status(steady(2.0)));
}

TEST(ClockOffset, InSilenceTheBoundsWiden) {
    PingedRobot robot(9);
    ClockOffset clock;
    run(robot, clock, 0.0, 30.0);
    const auto soon = *clock.status(steady(31.0)), late = *clock.status(steady(631.0));
    EXPECT_EQ(soon.ahead, late.ahead);
    EXPECT_NEAR(toSeconds(late.uncertainty - soon.uncertainty), 600.0 * PingClock::MaxDrift, 1e-4);
}

/// Samples at 20 Hz for @p duration seconds from @p begin.
void stamps(ClockOffset& clock, double begin, double duration, double ahead, unsigned seed,
            const Way& way = {0.010, 0.030}) {
    std::mt19937 random(seed);
    for (double t = begin; t < begin + duration; t += 0.05) {
        const double arrival = t + way(random);
        clock.stamp(day(t) + fromSeconds(ahead), day(arrival), steady(arrival));
    }
}

TEST(ClockOffset, StampsTellItOfRobotsWithoutPong) {
    ClockOffset clock;
    stamps(clock, 0.0, 20.0, 5.0, 1);
    const auto status = *clock.status(steady(20.0));
    EXPECT_EQ(status.source, ClockSource::Stamps);
    EXPECT_NEAR(toSeconds(status.ahead), 5.0, toSeconds(status.uncertainty));
    EXPECT_GE(status.uncertainty, 25ms);
    EXPECT_EQ(status.steps, 0);
}

TEST(ClockOffset, StampsFollowASteppingClock) {
    for (const double step : {5.0, -5.0}) {
        ClockOffset clock;
        stamps(clock, 0.0, 20.0, 1.0, 2);
        stamps(clock, 20.0, step > 0.0 ? 0.2 : 12.0, 1.0 + step, 3);
        const auto status = *clock.status(steady(33.0));
        EXPECT_NEAR(toSeconds(status.ahead), 1.0 + step, 0.060);
        EXPECT_EQ(status.steps, 1);
        EXPECT_NEAR(toSeconds(status.lastStep), step, 0.060);
    }
}

TEST(ClockOffset, ASingleStampFromTheFutureChangesNothing) {
    ClockOffset clock;
    stamps(clock, 0.0, 5.0, 1.0, 4);
    clock.stamp(day(900.0), day(5.01), steady(5.01));
    clock.stamp(day(700.0), day(5.02), steady(5.02));
    EXPECT_NEAR(toSeconds(clock.status(steady(5.1))->ahead), 1.0, 0.060);
    stamps(clock, 5.1, 5.0, 1.0, 5);
    EXPECT_EQ(clock.status(steady(10.1))->steps, 0);
}

TEST(ClockOffset, PingsAreBelievedBeforeStampsWhileTheyAreAnswered) {
    PingedRobot robot(10);
    robot.clockError = 2.0;
    ClockOffset clock;
    stamps(clock, 0.0, 5.0, 2.0, 6);
    run(robot, clock, 5.0, 10.0);
    stamps(clock, 15.0, 1.0, 2.0, 7);
    EXPECT_EQ(clock.status(steady(16.0))->source, ClockSource::Pings);
    EXPECT_LT(clock.status(steady(16.0))->uncertainty, 25ms);
    stamps(clock, 16.0, 70.0, 2.0, 8);
    EXPECT_EQ(clock.status(steady(86.0))->source, ClockSource::Stamps);
}

}  // namespace
}  // namespace leitstand::test
