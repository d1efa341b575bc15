#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/robot/control/drive_schedule.h"
#include "core/robot/control/drive_setpoint.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

constexpr double NaN = std::numeric_limits<double>::quiet_NaN(),
                 Infinite = std::numeric_limits<double>::infinity();
const DriveLimits Limits{0.5, 1.0, false};
const DriveVelocity Zero, Forward{0.4, 0.0, 0.2};

/// One whose sticks are neutral and permitted at 0.
DriveSetpoint ready() {
    DriveSetpoint setpoint(Limits);
    setpoint.permit(true);
    setpoint.set(Zero, at(0));
    return setpoint;
}

TEST(DriveSetpoint, TheNewestCountsForTwoHundredMilliseconds) {
    DriveSetpoint setpoint = ready();
    setpoint.set({0.1, 0.0, 0.0}, at(100));
    setpoint.set(Forward, at(110));
    EXPECT_EQ(setpoint.at(at(110)), Forward);
    EXPECT_EQ(setpoint.at(at(309)), Forward);
    EXPECT_EQ(setpoint.at(at(310)), Zero);
    EXPECT_FALSE(setpoint.isFresh(at(310)));
    setpoint.set(Forward, at(400));
    EXPECT_EQ(setpoint.at(at(400)), Forward) << "a hiccup of the window needs no neutral sticks";
    setpoint.set(Forward, at(1'099));
    EXPECT_EQ(setpoint.at(at(1'099)), Forward) << "expired for less than half a second";
}

TEST(DriveSetpoint, OneThatExpiredForHalfASecondNeedsNeutralSticksAgain) {
    for (const std::int64_t hang : {700, 1'000, 2'500, 10'000}) {
        DriveSetpoint setpoint = ready();
        setpoint.set(Forward, at(10));
        for (std::int64_t now = 10 + hang; now < 15'000; now += 20) {
            setpoint.set(Forward, at(now));
            ASSERT_EQ(setpoint.at(at(now)), Zero) << "hung for " << hang << " ms, at " << now;
            ASSERT_TRUE(setpoint.waitsForNeutral());
        }
        setpoint.set(Zero, at(15'000));
        setpoint.set(Forward, at(15'020));
        EXPECT_EQ(setpoint.at(at(15'020)), Forward) << "hung for " << hang << " ms";
    }
}

TEST(DriveSetpoint, SticksThatArePushedDuringAHangMoveNothing) {
    DriveSetpoint setpoint = ready();
    setpoint.set(Zero, at(10));
    setpoint.set(Forward, at(1'500));
    EXPECT_EQ(setpoint.at(at(1'500)), Zero) << "nobody saw the robot when the stick was pushed";
    setpoint.set(Zero, at(1'520));
    setpoint.set(Forward, at(1'540));
    EXPECT_EQ(setpoint.at(at(1'540)), Forward);
}

TEST(DriveSetpoint, WithoutPermissionItIsZeroAndSticksMustBeNeutralAfterwards) {
    DriveSetpoint setpoint(Limits);
    setpoint.set(Zero, at(0));
    setpoint.set(Forward, at(10));
    EXPECT_EQ(setpoint.at(at(10)), Zero);
    setpoint.permit(true);
    setpoint.set(Forward, at(20));
    EXPECT_EQ(setpoint.at(at(20)), Zero) << "what was neutral before there was permission does not count";
    EXPECT_TRUE(setpoint.waitsForNeutral());
    setpoint.set(Zero, at(30));
    setpoint.set(Forward, at(40));
    EXPECT_EQ(setpoint.at(at(40)), Forward);
    EXPECT_FALSE(setpoint.waitsForNeutral());
    setpoint.permit(false);
    EXPECT_EQ(setpoint.at(at(50)), Zero);
    setpoint.permit(true);
    EXPECT_EQ(setpoint.at(at(50)), Zero) << "it never moves on by itself";
}

TEST(DriveSetpoint, BrokenSticksAreZeroAndNotNeutral) {
    for (const DriveVelocity& broken :
         {DriveVelocity{NaN, 0, 0}, DriveVelocity{0, NaN, 0}, DriveVelocity{0, 0, NaN},
          DriveVelocity{Infinite, 0, 0}, DriveVelocity{0, 0, -Infinite}}) {
        DriveSetpoint setpoint = ready();
        setpoint.set(Forward, at(10));
        setpoint.set(broken, at(20));
        EXPECT_EQ(setpoint.at(at(20)), Zero);
        setpoint.set(Forward, at(30));
        EXPECT_EQ(setpoint.at(at(30)), Zero);
        setpoint.set(Zero, at(40));
        setpoint.set(Forward, at(50));
        EXPECT_EQ(setpoint.at(at(50)), Forward);
    }
}

TEST(DriveSetpoint, StaysWithinTheRobotsLimits) {
    struct Case {
        DriveVelocity asked, expected;
        DriveLimits limits;
    };
    const DriveLimits omni{0.5, 1.0, true};
    const double huge = std::numeric_limits<double>::max();
    const std::vector<Case> cases = {
        {{2.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, Limits},
        {{-2.0, 0.0, -3.0}, {-0.5, 0.0, -1.0}, Limits},
        {{0.1, 0.3, 0.0}, {0.1, 0.0, 0.0}, Limits},
        {{0.3, 0.4, 0.1}, {0.3, 0.4, 0.1}, omni},
        {{3.0, -4.0, 0.0}, {0.3, -0.4, 0.0}, omni},
        {{huge, huge, huge}, {0.0, 0.0, 1.0}, omni},
        {{1.0, 0.0, 1.0}, {0.0, 0.0, 0.0}, DriveLimits{}},
        {{1.0, 0.0, 1.0}, {0.0, 0.0, 0.0}, {NaN, -1.0, false}},
        {{NaN, 0.0, 1.0}, {0.0, 0.0, 0.0}, Limits},
    };
    for (const Case& one : cases) {
        const DriveVelocity got = limited(one.asked, one.limits);
        EXPECT_NEAR(got.forward, one.expected.forward, 1e-12) << one.asked.forward;
        EXPECT_NEAR(got.left, one.expected.left, 1e-12) << one.asked.forward;
        EXPECT_NEAR(got.turn, one.expected.turn, 1e-12) << one.asked.forward;
    }
}

TEST(DriveSetpoint, TracksTurnAboutTheMiddle) {
    RobotDescription robot;
    robot.footprint = {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}};
    EXPECT_DOUBLE_EQ(trackDistance(robot), 0.4);
    const auto [left, right] = tracksOf({0.3, 0.0, 0.5}, 0.4);
    EXPECT_DOUBLE_EQ(left, 0.2);
    EXPECT_DOUBLE_EQ(right, 0.4);
    const DriveVelocity back = velocityOf({left, right}, 0.4);
    EXPECT_DOUBLE_EQ(back.forward, 0.3);
    EXPECT_DOUBLE_EQ(back.turn, 0.5);
    EXPECT_EQ(trackDistance(RobotDescription{}), 0.0);
    EXPECT_EQ(velocityOf({0.1, 0.2}, 0.0).turn, 0.0);
}

/// The moments at which something is sent from @p from to @p until, looked at when the schedule says so.
std::vector<std::int64_t> sent(DriveSchedule& schedule, const DriveVelocity& velocity, bool driving,
                               std::int64_t from, std::int64_t until, std::int64_t late = 0) {
    std::vector<std::int64_t> moments;
    for (std::int64_t now = from; now < until;) {
        const auto decision = schedule.decide(velocity, driving, at(now));
        if (decision.send) moments.push_back(now);
        const auto next =
            std::chrono::duration_cast<std::chrono::milliseconds>(decision.next - at(now)).count();
        EXPECT_GT(next, 0);
        now += std::max<std::int64_t>(next, 1) + late;
    }
    return moments;
}

TEST(DriveSchedule, RepeatsAtFortyHertzEvenWhenItWakesLate) {
    DriveSchedule punctual;
    EXPECT_EQ(sent(punctual, Forward, true, 0, 1'000).size(), 40U);
    DriveSchedule late;
    EXPECT_NEAR(static_cast<double>(sent(late, Forward, true, 0, 10'000, 7).size()), 400.0, 4.0);
    DriveSchedule overslept;
    static_cast<void>(overslept.decide(Forward, true, at(0)));
    EXPECT_TRUE(overslept.decide(Forward, true, at(5'000)).send);
    EXPECT_FALSE(overslept.decide(Forward, true, at(5'001)).send) << "no burst for what was missed";
}

TEST(DriveSchedule, FiveCommandsLostInARowStarveNoWatchdog) {
    DriveSchedule schedule;
    constexpr std::int64_t Watchdog = 200, Delay = 50;  // [ms]
    EXPECT_GE(sent(schedule, Forward, true, 0, Watchdog - Delay).size(), 6U);
}

TEST(DriveSchedule, ChangesGoOutAtOnceButNoFloodOfThem) {
    DriveSchedule schedule;
    EXPECT_TRUE(schedule.decide(Forward, true, at(0)).send);
    const auto early = schedule.decide({0.3, 0, 0}, true, at(4));
    EXPECT_FALSE(early.send);
    EXPECT_EQ(early.next, at(10));
    EXPECT_TRUE(schedule.decide({0.3, 0, 0}, true, at(10)).send);
    EXPECT_TRUE(schedule.decide(Zero, true, at(11)).send) << "zero waits for nothing";
    int count = 0;
    for (std::int64_t now = 100; now < 1'100; ++now) {
        count += schedule.decide({1e-4 * static_cast<double>(now), 0, 0}, true, at(now)).send ? 1 : 0;
    }
    EXPECT_NEAR(count, 100, 2) << "a pad at 1 kHz";
}

TEST(DriveSchedule, SaysWhetherMoreCommandsFollow) {
    DriveSchedule schedule;
    EXPECT_FALSE(schedule.decide(Zero, false, at(0)).speaks);
    EXPECT_TRUE(schedule.decide(Forward, true, at(100)).speaks);
    EXPECT_TRUE(schedule.decide(Forward, true, at(110)).speaks) << "nothing is due, but soon";
    int zeros = 0;
    for (std::int64_t now = 150; now < 2'000; now += 25) {
        const auto decision = schedule.decide(Zero, false, at(now));
        zeros += decision.send ? 1 : 0;
        EXPECT_EQ(decision.speaks, zeros < 40) << now;
    }
    EXPECT_EQ(zeros, 40);
}

TEST(DriveSchedule, AfterDrivingASecondOfZerosAndThenSilence) {
    DriveSchedule schedule;
    EXPECT_TRUE(sent(schedule, Zero, false, 0, 1'000).empty()) << "who never drove says nothing";
    EXPECT_FALSE(sent(schedule, Forward, true, 1'000, 2'000).empty());
    const auto zeros = sent(schedule, Zero, false, 2'000, 10'000);
    EXPECT_EQ(zeros.size(), 40U);
    EXPECT_EQ(zeros.front(), 2'000);
    EXPECT_LT(zeros.back(), 3'000);
    EXPECT_EQ(sent(schedule, Zero, true, 10'000, 11'000).size(), 40U) << "neutral sticks in hand speak on";
}

}  // namespace
}  // namespace leitstand::test
