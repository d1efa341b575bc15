#include "core/station/preflight/brake_test.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/station/preflight/brake_format.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Verdict = BrakeResult::Verdict;
using Phase = BrakeTest::Phase;
using testing::HasSubstr;

/// A robot that does what it is told, and stands @p watchdog after it is told nothing.
class Track {
public:
    /// Steps of 20 ms until the test is over, at most 10 s; odometry comes @p late.
    const BrakeResult& run() {
        test.start(now);
        for (int i = 0; i < 500 && test.isRunning(); ++i) tick();
        return test.result();
    }
    void tick() {
        now += 20ms;
        if (holding) test.hold(now);
        const BrakeTest::Step step = test.step(facts, now);
        silent = step.silent;
        if (!step.silent) {
            request = step.sticks.forward;
            reported = now;
        } else if (now - reported > watchdog) {
            request = 0.0;
        }
        if (moves) speed += std::clamp(request - speed, -0.02, 0.02);
        x += 0.02 * speed;
        stamp += 20ms;
        test.odometry(stamp, {x, 0.0}, speed, 0.0);
    }
    BrakeTest test;
    BrakeFacts facts{.mayDrive = true, .listening = true, .needsNeutral = false, .spaceAhead = 2.0};
    std::chrono::nanoseconds watchdog = 300ms;
    bool holding = true, moves = true, silent = false;
    SteadyTime now{100s}, reported{100s};
    Time stamp{std::chrono::seconds(5'000)};  // its clock is another one
    double speed = 0.0, x = 0.0, request = 0.0;
};

TEST(BrakeTest, ARobotWithAWatchdogPasses) {
    Track track;
    const BrakeResult& result = track.run();
    EXPECT_EQ(result.verdict, Verdict::Passed) << toString(result);
    EXPECT_NEAR(result.seconds, 0.42, 0.08);
    EXPECT_NEAR(result.metres, 0.035, 0.01);
    EXPECT_LT(track.x, 0.2) << "it needs little room";
    EXPECT_EQ(result.watchdog, BrakeResult::Watchdog::Stops);
    EXPECT_NEAR(result.brakesAfter, 0.3, 0.05) << "the time of its watchdog, without that of its brakes";
    EXPECT_FALSE(result.showsNoWatchdog());
}

TEST(BrakeTest, TheWatchdogOfARobotIsMeasured) {
    for (const auto watchdog : {100ms, 200ms, 300ms, 600ms, 1'000ms, 1'300ms}) {
        Track track;
        track.watchdog = watchdog;
        const BrakeResult& result = track.run();
        EXPECT_EQ(result.watchdog, BrakeResult::Watchdog::Stops) << watchdog.count();
        EXPECT_NEAR(result.brakesAfter, std::chrono::duration<double>(watchdog).count(), 0.05);
        EXPECT_GT(result.seconds, result.brakesAfter);
        EXPECT_FALSE(result.showsNoWatchdog());
        EXPECT_EQ(result.verdict, watchdog <= 300ms ? Verdict::Passed : Verdict::Failed) << watchdog.count();
    }
}

TEST(BrakeTest, OneThatGoesOnFailsAndIsStopped) {
    Track track;
    track.watchdog = 1h;
    EXPECT_EQ(track.run().verdict, Verdict::Failed);
    EXPECT_GT(track.test.result().seconds, 1.4);
    EXPECT_EQ(track.test.result().watchdog, BrakeResult::Watchdog::None);
    EXPECT_TRUE(track.test.result().showsNoWatchdog());
    for (int i = 0; i < 20; ++i) track.tick();
    EXPECT_FALSE(track.silent) << "zeros again";
    EXPECT_EQ(track.speed, 0.0);
}

TEST(BrakeTest, OneThatStopsLateFails) {
    Track track;
    track.watchdog = 600ms;
    EXPECT_EQ(track.run().verdict, Verdict::Failed);
    EXPECT_NEAR(track.test.result().seconds, 0.7, 0.1);
    EXPECT_FALSE(track.test.result().showsNoWatchdog()) << "it has one, which is slow";
}

TEST(BrakeTest, LettingTheKeyGoEndsItWithoutAVerdict) {
    Track track;
    track.test.start(track.now);
    while (track.test.phase() != Phase::Driving) track.tick();
    track.holding = false;
    for (int i = 0; i < 20; ++i) track.tick();
    EXPECT_EQ(track.test.result().verdict, Verdict::Inconclusive);
    EXPECT_THAT(toString(track.test.result()), HasSubstr("key_released"));
    EXPECT_EQ(track.request, 0.0);
    EXPECT_FALSE(track.silent);
}

TEST(BrakeTest, AStopMeanwhileEndsItAndZerosAreSent) {
    Track track;
    track.watchdog = 1h;
    track.test.start(track.now);
    while (track.test.phase() != Phase::Cut) track.tick();
    EXPECT_TRUE(track.silent);
    track.facts.mayDrive = false;
    track.tick();
    EXPECT_FALSE(track.silent);
    EXPECT_EQ(track.test.result().verdict, Verdict::Inconclusive);
}

TEST(BrakeTest, NothingMovesWithoutRoomGrantNeutralSticksOrEars) {
    for (const double space : {0.3, std::numeric_limits<double>::quiet_NaN()}) {
        Track track;
        track.facts.spaceAhead = space;
        EXPECT_EQ(track.run().verdict, Verdict::Inconclusive);
        EXPECT_EQ(track.x, 0.0);
    }
    for (bool BrakeFacts::*fact :
         {&BrakeFacts::mayDrive, &BrakeFacts::listening, &BrakeFacts::needsNeutral}) {
        Track track;
        track.facts.*fact = fact == &BrakeFacts::needsNeutral;
        EXPECT_EQ(track.run().verdict, Verdict::Inconclusive);
        EXPECT_EQ(track.x, 0.0);
        EXPECT_NE(track.test.result().cause, BrakeResult::Cause::None);
    }
}

TEST(BrakeTest, ARobotThatDoesNotMoveProvesNothing) {
    Track track;
    track.moves = false;
    EXPECT_EQ(track.run().verdict, Verdict::Inconclusive);
    EXPECT_THAT(toString(track.test.result()), HasSubstr("too_slow"));
}

TEST(BrakeTest, WithoutOdometryAfterTheCutNothingIsKnown) {
    Track track;
    track.test.start(track.now);
    while (track.test.phase() != Phase::Cut) track.tick();
    for (int i = 0; i < 400 && track.test.isRunning(); ++i) {
        track.now += 20ms;
        (void)track.test.step(track.facts, track.now);
    }
    EXPECT_EQ(track.test.result().verdict, Verdict::Inconclusive);
    EXPECT_THAT(toString(track.test.result()), HasSubstr("odometry"));
    EXPECT_EQ(track.test.result().watchdog, BrakeResult::Watchdog::Unknown);
}

}  // namespace
}  // namespace leitstand::test
