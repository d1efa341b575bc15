#include <limits>

#include <gtest/gtest.h>

#include "core/event/command_samples.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/robot/control/robot_rules.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

using Action = GrantSample::Action;
const DriveVelocity Zero, Forward{0.4, 0.0, 0.2};

class Rules : public testing::Test {
protected:
    Rules() { hold("a", 1, 0); }
    void hold(const std::string& station, std::uint8_t process, std::int64_t now) {
        m_rules.receive(grantSaying(station, Action::Hold), sender(process), at(now));
    }
    DriveVerdict drive(const DriveVelocity& velocity, std::int64_t now, std::uint8_t process = 1) {
        return m_rules.drive(velocity, sender(process), at(now));
    }
    [[nodiscard]] DriveVelocity commanded(std::int64_t now) const { return m_rules.commanded(at(now)); }
    RobotRules m_rules{"kurt3d", {.limits = {0.5, 1.0, false}}};
};

TEST_F(Rules, TheHoldersCommandsCountForTwoHundredMilliseconds) {
    EXPECT_EQ(commanded(0), Zero);
    EXPECT_EQ(drive(Zero, 0), DriveVerdict::Taken);
    EXPECT_EQ(drive(Forward, 10), DriveVerdict::Taken);
    EXPECT_EQ(commanded(209), Forward);
    EXPECT_EQ(commanded(210), Zero);
    EXPECT_EQ(drive({3.0, 0.0, 0.0}, 400), DriveVerdict::Taken);
    EXPECT_EQ(commanded(400).forward, 0.5) << "no faster than the robot may";
}

TEST_F(Rules, AfterALongSilenceTheFirstCommandIsZero) {
    static_cast<void>(drive(Zero, 0));
    static_cast<void>(drive(Forward, 10));
    EXPECT_EQ(drive(Forward, 709), DriveVerdict::Taken) << "a gap in the link";
    EXPECT_EQ(drive(Forward, 1'409), DriveVerdict::NotNeutral) << "a station that hung";
    EXPECT_EQ(commanded(1'409), Zero);
    EXPECT_EQ(drive(Forward, 1'459), DriveVerdict::NotNeutral) << "the stick is still held";
    EXPECT_EQ(drive(Zero, 1'509), DriveVerdict::Taken);
    EXPECT_EQ(drive(Forward, 1'559), DriveVerdict::Taken);
    EXPECT_EQ(commanded(1'559), Forward);
}

TEST_F(Rules, NobodyElseMovesIt) {
    static_cast<void>(drive(Zero, 0));
    static_cast<void>(drive(Forward, 10));
    EXPECT_EQ(drive({-0.4, 0.0, 0.0}, 20, 2), DriveVerdict::NotHolder);
    EXPECT_EQ(commanded(20), Forward);
}

TEST_F(Rules, ANewHolderBeginsWithZero) {
    static_cast<void>(drive(Zero, 0));
    static_cast<void>(drive(Forward, 10));
    m_rules.receive(grantSaying("a", Action::Consent, 1, "b"), sender(1), at(20));
    EXPECT_EQ(commanded(20), Zero) << "at once";
    hold("b", 2, 30);
    EXPECT_EQ(commanded(30), Zero);
    EXPECT_EQ(drive(Forward, 40, 2), DriveVerdict::NotNeutral);
    EXPECT_EQ(commanded(40), Zero);
    EXPECT_EQ(drive(Forward, 40, 1), DriveVerdict::NotHolder);
    EXPECT_EQ(drive(Zero, 50, 2), DriveVerdict::Taken);
    EXPECT_EQ(drive(Forward, 60, 2), DriveVerdict::Taken);
    EXPECT_EQ(commanded(60), Forward);
}

TEST_F(Rules, AZeroThatOvertookItsGrantCountsForASecond) {
    const auto change = [&](std::int64_t now) {
        m_rules.receive(grantSaying("a", Action::Consent, 1, "b"), sender(1), at(now));
        hold("b", 2, now);
    };
    EXPECT_EQ(drive(Zero, 10, 2), DriveVerdict::NotHolder);
    EXPECT_EQ(drive(Forward, 15, 2), DriveVerdict::NotHolder);
    EXPECT_EQ(drive(Zero, 16, 3), DriveVerdict::NotHolder) << "somebody else's";
    change(20);
    EXPECT_EQ(commanded(20), Zero);
    EXPECT_EQ(drive(Forward, 30, 2), DriveVerdict::NotNeutral) << "the newest zero was another's";
    EXPECT_EQ(drive(Zero, 40, 2), DriveVerdict::Taken);
}

TEST_F(Rules, SticksThatArePushedBeforeTheGrantIsHeardMoveTheRobotOnceItIs) {
    EXPECT_EQ(drive(Zero, 10, 2), DriveVerdict::NotHolder);
    EXPECT_EQ(drive(Forward, 15, 2), DriveVerdict::NotHolder);
    m_rules.receive(grantSaying("a", Action::Consent, 1, "b"), sender(1), at(20));
    hold("b", 2, 20);
    EXPECT_EQ(commanded(20), Zero) << "what was said before it had the grant moves nothing";
    EXPECT_EQ(drive(Forward, 30, 2), DriveVerdict::Taken);
    EXPECT_EQ(commanded(30), Forward);
}

TEST_F(Rules, AZeroOfLongAgoOrBeforeAStopCountsNoMore) {
    const auto change = [&](std::int64_t now) {
        m_rules.receive(grantSaying("a", Action::Consent, 1, "b"), sender(1), at(now));
        hold("b", 2, now);
    };
    EXPECT_EQ(drive(Zero, 10, 2), DriveVerdict::NotHolder);
    change(20);
    EXPECT_EQ(drive(Forward, 1'010, 2), DriveVerdict::NotNeutral);
    RobotRules stopped{"kurt3d", {.limits = {0.5, 1.0, false}}};
    EXPECT_EQ(stopped.drive(Zero, sender(2), at(10)), DriveVerdict::NotHolder);
    const auto state = stopped.receive({{}, "viewer", 1, true, 0}, sender(7), at(20));
    stopped.receive(grantSaying("b", Action::Hold), sender(2), at(30));
    EXPECT_FALSE(stopped.receive({{}, "b", 2, false, state.stops}, sender(2), at(40)).stopped);
    EXPECT_EQ(stopped.drive(Forward, sender(2), at(50)), DriveVerdict::NotNeutral);
}

TEST_F(Rules, ASilentHolderMovesNothing) {
    static_cast<void>(drive(Zero, 2'900));
    static_cast<void>(drive(Forward, 2'950));
    EXPECT_EQ(commanded(2'999), Forward);
    EXPECT_EQ(commanded(3'000), Zero);
    EXPECT_EQ(drive(Forward, 3'010), DriveVerdict::NotHolder);
}

TEST_F(Rules, AStopLatchesAndSticksMustBeNeutralAfterItsRelease) {
    static_cast<void>(drive(Zero, 0));
    static_cast<void>(drive(Forward, 10));
    const StopStateSample stopped = m_rules.receive({{}, "viewer", 1, true, 0}, sender(7), at(20));
    EXPECT_TRUE(stopped.stopped);
    EXPECT_EQ(commanded(20), Zero);
    EXPECT_EQ(drive(Forward, 30), DriveVerdict::Stopped);
    EXPECT_EQ(drive(Zero, 40), DriveVerdict::Stopped);
    EXPECT_TRUE(m_rules.receive({{}, "b", 2, false, stopped.stops}, sender(2), at(50)).stopped)
        << "not the holder";
    EXPECT_TRUE(m_rules.receive({{}, "a", 2, false, stopped.stops}, sender(2), at(50)).stopped)
        << "only says so";
    EXPECT_TRUE(m_rules.receive({{}, "b", 2, false, stopped.stops}, sender(1), at(50)).stopped) << "neither";
    EXPECT_FALSE(m_rules.receive({{}, "a", 3, false, stopped.stops}, sender(1), at(50)).stopped);
    EXPECT_EQ(commanded(60), Zero) << "it never moves on by itself";
    EXPECT_EQ(drive(Forward, 70), DriveVerdict::NotNeutral);
    EXPECT_EQ(drive(Zero, 80), DriveVerdict::Taken);
    EXPECT_EQ(drive(Forward, 90), DriveVerdict::Taken);
    EXPECT_EQ(commanded(90), Forward);
    m_rules.press();
    EXPECT_EQ(commanded(90), Zero);
}

TEST_F(Rules, WhatIsNoNumberStops) {
    static_cast<void>(drive(Zero, 0));
    static_cast<void>(drive(Forward, 10));
    EXPECT_EQ(drive({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, 20), DriveVerdict::NoNumber);
    EXPECT_EQ(commanded(20), Zero);
}

TEST_F(Rules, ACarelessRobotObeysAnybodyForEverButStops) {
    RobotRules careless{"kurt3d", {.limits = {0.5, 1.0, false}, .careless = true}};
    EXPECT_EQ(careless.drive(Forward, sender(7), at(0)), DriveVerdict::Taken);
    EXPECT_EQ(careless.commanded(at(3'600'000)), Forward);
    EXPECT_EQ(careless.drive({3.0, 0.0, 0.0}, sender(8), at(3'600'000)), DriveVerdict::Taken);
    EXPECT_EQ(careless.commanded(at(3'600'000)).forward, 0.5);
    static_cast<void>(careless.receive({{}, "viewer", 1, true, 0}, sender(7), at(3'600'010)));
    EXPECT_EQ(careless.commanded(at(3'600'010)), Zero);
    EXPECT_EQ(careless.drive(Forward, sender(7), at(3'600'020)), DriveVerdict::Stopped);
}

TEST_F(Rules, TellsWhetherItStands) {
    EXPECT_FALSE(m_rules.stopState(at(0)).standing);
    for (int now = 0; now <= 250; now += 50) m_rules.moved(0.0, 0.0, at(now));
    EXPECT_TRUE(m_rules.stopState(at(250)).standing);
}

}  // namespace
}  // namespace leitstand::test
