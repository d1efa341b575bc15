#include "robots/control/modes.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using enum DriveMode;
constexpr DriveVelocity Ahead{0.3, 0.0, 0.1};

/// A machine with a clock, a link and sticks.
class Robot {
public:
    explicit Robot(std::map<std::string, LinkLossRule> rules = {})
        : m_machine([&rules] {
              ModeSettings settings;
              settings.hasRemote = true;
              settings.linkLoss = std::move(rules);
              return settings;
          }()) {}

    /// Lets @p seconds pass, with what holds now, at 20 Hz.
    ModeDecision run(double seconds = 0.1) {
        ModeDecision decision;
        bool changed = false;
        for (int i = 0; i < std::max(1, static_cast<int>(std::lround(seconds * 20))); ++i) {
            m_now += std::chrono::milliseconds(50);
            if (link) m_machine.receivedStation(m_now);
            if (sticks && link) m_machine.command(*sticks, m_now);
            decision = m_machine.step(inputs, m_now);
            changed = changed || decision.changed;
        }
        decision.changed = changed;
        return decision;
    }
    /// Sticks neutral, then ahead.
    ModeDecision drive() {
        sticks = DriveVelocity{};
        run();
        sticks = Ahead;
        return run();
    }
    Result<void> ask(DriveMode mode) { return m_machine.request(mode, m_now); }
    ModeMachine& machine() { return m_machine; }
    [[nodiscard]] Time now() const { return m_now; }

    bool link = true;
    std::optional<DriveVelocity> sticks;
    ModeInputs inputs;

private:
    ModeMachine m_machine;
    Time m_now = Time(std::chrono::seconds(1000));
};

/// A robot brought to @p mode.
Robot robotIn(DriveMode mode) {
    Robot robot({{"explore", LinkLossRule::FinishAndWait}, {"victim_approach", LinkLossRule::FinishAndWait}});
    robot.run();
    switch (mode) {
        case Stopped:
            robot.inputs.stopped = true;
            break;
        case Remote:
            robot.inputs.remote = DriveVelocity{};
            break;
        case VictimApproach:
            EXPECT_TRUE(robot.ask(Explore));
            robot.inputs.cue = true;
            break;
        default:
            EXPECT_TRUE(robot.ask(mode));
    }
    EXPECT_EQ(robot.run().mode, mode);
    return robot;
}

constexpr DriveMode All[] = {Stopped, Teleoperation, SafeTeleoperation, Explore, VictimApproach, Remote};

TEST(Modes, HaveNames) {
    for (const DriveMode mode : All) EXPECT_EQ(driveModeFrom(toString(mode)), mode);
    EXPECT_EQ(toString(SafeTeleoperation), "safe_teleoperation");
    EXPECT_FALSE(driveModeFrom("hover"));
}

TEST(Modes, EveryRequestFromEveryModeIsTakenOrRefusedWithAReason) {
    for (const DriveMode from : All) {
        for (const DriveMode to : All) {
            Robot robot = robotIn(from);
            const auto answer = robot.ask(to);
            const bool may = from != Stopped && from != Remote && to != Stopped && to != Remote &&
                             (to != VictimApproach || from == VictimApproach);
            EXPECT_EQ(answer.ok(), may) << toString(from) << " to " << toString(to);
            EXPECT_TRUE(answer.ok() || !answer.error().text.empty());
            robot.inputs.cue = robot.inputs.cue && to == VictimApproach;
            EXPECT_EQ(robot.run().mode, may ? to : from) << toString(from) << " to " << toString(to);
        }
    }
    Robot robot;
    EXPECT_EQ(robot.machine().request("hover", robot.now()).error().text, "expected a mode, found \"hover\"");
}

TEST(Modes, StopComesFromEveryModeAndStays) {
    for (const DriveMode from : All) {
        Robot robot = robotIn(from);
        robot.sticks = Ahead;
        robot.inputs.stopped = true;
        robot.inputs.stopReason = "stop by the station";
        ModeDecision decision = robot.run();
        EXPECT_EQ(decision.mode, Stopped);
        EXPECT_EQ(decision.driver, Driver::Nobody);
        EXPECT_TRUE(from == Stopped || decision.reason == "stop by the station") << decision.reason;
        decision = robot.run(5.0);
        EXPECT_EQ(decision.mode, Stopped) << "latched";
        EXPECT_FALSE(decision.changed);
        robot.inputs.remote = Ahead;
        EXPECT_EQ(robot.run().driver, Driver::Nobody) << "the stop is above the remote";
        robot.inputs.remote.reset();
        robot.run(1.0);

        robot.inputs.stopped = false;
        decision = robot.run(3.0);
        EXPECT_TRUE(decision.mode == Teleoperation || decision.mode == SafeTeleoperation) << toString(from);
        EXPECT_EQ(decision.driver, Driver::Nobody) << "the stick was held all the time";
        EXPECT_TRUE(decision.waitsForNeutral);
        decision = robot.drive();
        EXPECT_NE(decision.driver, Driver::Nobody);
        EXPECT_EQ(decision.velocity, Ahead);
    }
}

TEST(Modes, AnAutonomousModeDoesNotComeBackAfterAStop) {
    Robot robot = robotIn(Explore);
    robot.inputs.stopped = true;
    robot.run();
    robot.inputs.stopped = false;
    for (int i = 0; i < 20; ++i) {
        const ModeDecision decision = robot.run(0.5);
        EXPECT_EQ(decision.mode, Teleoperation);
        EXPECT_EQ(decision.driver, Driver::Nobody);
    }
    EXPECT_TRUE(robot.ask(Explore));
    EXPECT_EQ(robot.run().driver, Driver::Explorer);
}

TEST(Modes, TheOperatorDrivesWhenTheSticksWereNeutral) {
    Robot robot;
    robot.sticks = Ahead;
    EXPECT_EQ(robot.run().driver, Driver::Nobody);
    EXPECT_TRUE(robot.run().waitsForNeutral);
    EXPECT_EQ(robot.drive().driver, Driver::Operator);
    EXPECT_TRUE(robot.ask(SafeTeleoperation));
    EXPECT_EQ(robot.run().driver, Driver::LimitedOperator) << "the same sticks drive on";
    EXPECT_TRUE(robot.ask(Explore));
    EXPECT_EQ(robot.run().driver, Driver::Explorer);
    EXPECT_TRUE(robot.ask(Teleoperation));
    EXPECT_EQ(robot.run().driver, Driver::Nobody) << "held since before";
    EXPECT_EQ(robot.drive().driver, Driver::Operator);
}

TEST(Modes, TheWatchdogStopsAfterTwoTenthsOfASecond) {
    Robot robot;
    EXPECT_EQ(robot.drive().driver, Driver::Operator);
    robot.sticks.reset();
    EXPECT_EQ(robot.run(0.15).driver, Driver::Operator);
    EXPECT_EQ(robot.run(0.05).driver, Driver::Nobody);
    robot.sticks = Ahead;
    EXPECT_EQ(robot.run().driver, Driver::Operator) << "the hand is still on the stick";
    robot.sticks = DriveVelocity{std::nan(""), 0.0, 0.0};
    EXPECT_TRUE(isZero(robot.run().velocity));
}

TEST(Modes, SticksThatAreHeldOverALostLinkAreToldUntilTheyAreLetGoOf) {
    Robot robot;
    EXPECT_EQ(robot.drive().driver, Driver::Operator);
    robot.link = false;
    EXPECT_EQ(robot.run(5.0).reason, "link lost: stands");
    robot.link = true;
    const ModeDecision back = robot.run(0.5);
    EXPECT_EQ(back.driver, Driver::Nobody);
    EXPECT_EQ(back.reason, "sticks must be neutral first") << "nothing else says why it stands";
    EXPECT_EQ(robot.machine().sample().reason, back.reason);
    EXPECT_FALSE(robot.run(0.5).changed) << "told once";
    const ModeDecision free = robot.drive();
    EXPECT_EQ(free.driver, Driver::Operator);
    EXPECT_EQ(free.reason, "the link is back");
}

TEST(Modes, ThatTheLinkIsBackIsNewsForSomeSecondsOnly) {
    Robot robot;
    const std::string usual = robot.drive().reason;
    for (int loss = 0; loss < 2; ++loss) {
        robot.link = false;
        robot.run(5.0);
        robot.link = true;
        EXPECT_EQ(robot.drive().reason, "the link is back");
        EXPECT_EQ(robot.run(3.0).reason, "the link is back");
        EXPECT_EQ(robot.run(5.0).reason, usual) << "it drives as before";
    }
}

TEST(Modes, ALostLinkStopsTeleoperationAndNeedsNeutralSticks) {
    for (const DriveMode mode : {Teleoperation, SafeTeleoperation}) {
        Robot robot = robotIn(mode);
        robot.drive();
        robot.link = false;
        EXPECT_EQ(robot.run(0.4).driver, Driver::Nobody);
        const ModeDecision lost = robot.run(4.0);
        EXPECT_TRUE(lost.linkLost);
        EXPECT_EQ(lost.mode, mode);
        EXPECT_EQ(lost.reason, "link lost: stands");
        robot.link = true;
        EXPECT_EQ(robot.run(1.0).driver, Driver::Nobody) << "the stick was held all the time";
        EXPECT_NE(robot.drive().driver, Driver::Nobody);
    }
}

TEST(Modes, WithoutAStationNobodyDrives) {
    Robot robot;
    robot.link = false;
    robot.sticks = Ahead;
    EXPECT_EQ(robot.run(5.0).driver, Driver::Nobody);
}

TEST(Modes, RuleStopHoldsAnAutonomousRobotUntilItIsAskedAgain) {
    Robot robot({{"explore", LinkLossRule::Stop}});
    robot.run();
    EXPECT_TRUE(robot.ask(Explore));
    EXPECT_EQ(robot.run().driver, Driver::Explorer);
    robot.link = false;
    EXPECT_EQ(robot.run(2.5).driver, Driver::Explorer);
    EXPECT_EQ(robot.run(1.0).driver, Driver::Nobody);
    robot.link = true;
    const ModeDecision back = robot.run(5.0);
    EXPECT_EQ(back.driver, Driver::Nobody);
    EXPECT_EQ(back.reason, "the link is back: waits to be asked again");
    EXPECT_TRUE(robot.ask(Explore));
    EXPECT_EQ(robot.run().driver, Driver::Explorer);
}

TEST(Modes, RuleFinishGoesOnUntilDoneThenWaits) {
    Robot robot = robotIn(Explore);
    robot.link = false;
    EXPECT_EQ(robot.run(20.0).driver, Driver::Explorer);
    robot.inputs.done = true;
    EXPECT_EQ(robot.run().driver, Driver::Nobody);
    robot.inputs.done = false;
    EXPECT_EQ(robot.run(10.0).driver, Driver::Nobody);
    robot.link = true;
    EXPECT_EQ(robot.run(5.0).driver, Driver::Nobody) << "waits to be asked";

    Robot endless = robotIn(Explore);
    endless.link = false;
    EXPECT_EQ(endless.run(62.0).driver, Driver::Explorer);
    EXPECT_EQ(endless.run(3.0).driver, Driver::Nobody) << "not for ever";

    Robot gap = robotIn(Explore);
    gap.link = false;
    gap.run(10.0);
    gap.link = true;
    EXPECT_EQ(gap.run(1.0).driver, Driver::Explorer) << "it never stood";
}

TEST(Modes, RuleReturnDrivesBackAndWaits) {
    Robot robot({{"explore", LinkLossRule::ReturnToLink}});
    robot.run();
    EXPECT_TRUE(robot.ask(Explore));
    robot.run();
    robot.link = false;
    const ModeDecision lost = robot.run(4.0);
    EXPECT_EQ(lost.driver, Driver::Returner);
    EXPECT_EQ(lost.mode, Explore);
    robot.inputs.cue = true;
    EXPECT_EQ(robot.run().driver, Driver::Returner) << "no adventures on the way";
    robot.inputs.done = true;
    EXPECT_EQ(robot.run().driver, Driver::Nobody);
    robot.inputs = {};
    robot.link = true;
    EXPECT_EQ(robot.run(3.0).driver, Driver::Nobody);

    Robot early({{"explore", LinkLossRule::ReturnToLink}});
    early.run();
    EXPECT_TRUE(early.ask(Explore));
    early.run();
    early.link = false;
    early.run(4.0);
    early.link = true;
    const ModeDecision back = early.run();
    EXPECT_EQ(back.driver, Driver::Nobody) << "the link came back on the way";
    EXPECT_EQ(back.reason, "the link is back: waits to be asked again");
}

TEST(Modes, ARobotThatIsSentSomewhereGoesThereThoughABodyIsInSight) {
    Robot robot = robotIn(Explore);
    robot.inputs.cue = robot.inputs.sent = true;
    EXPECT_EQ(robot.run(5.0).driver, Driver::Explorer);
    EXPECT_TRUE(robot.ask(VictimApproach)) << "unless the operator wants it to";
    EXPECT_EQ(robot.run().driver, Driver::Approacher);
    EXPECT_TRUE(robot.ask(Explore));
    robot.inputs.done = true;
    robot.inputs.report = "at the goal";
    EXPECT_EQ(robot.run().reason, "at the goal");
    robot.inputs = {};
    robot.inputs.cue = true;
    EXPECT_EQ(robot.run(5.0).driver, Driver::Nobody) << "waits there";
    EXPECT_TRUE(robot.ask(Explore));
    EXPECT_EQ(robot.run().driver, Driver::Approacher);
}

TEST(Modes, HeatTakesAnExploringRobotToTheVictim) {
    Robot robot = robotIn(Explore);
    robot.inputs.cue = true;
    ModeDecision decision = robot.run();
    EXPECT_EQ(decision.mode, VictimApproach);
    EXPECT_EQ(decision.driver, Driver::Approacher);
    EXPECT_EQ(decision.reason, "body heat in sight");
    EXPECT_TRUE(decision.changed);
    robot.inputs.done = true;
    robot.inputs.report = "stands 0.80 m in front of a victim";
    decision = robot.run(10.0);
    EXPECT_EQ(decision.mode, VictimApproach) << "waits";
    EXPECT_EQ(decision.driver, Driver::Nobody);
    EXPECT_EQ(decision.reason, "stands 0.80 m in front of a victim");
    robot.inputs = {};
    EXPECT_TRUE(robot.ask(Explore));
    EXPECT_EQ(robot.run().driver, Driver::Explorer);
}

TEST(Modes, ALostCueGoesBackToWhereItCameFrom) {
    Robot robot = robotIn(VictimApproach);
    robot.inputs = {};
    robot.inputs.failed = true;
    robot.inputs.report = "the heat was lost";
    ModeDecision decision = robot.run(0.05);
    EXPECT_EQ(decision.mode, Explore);
    EXPECT_EQ(decision.reason, "the heat was lost");

    Robot asked;
    asked.inputs.cue = true;
    asked.run();
    EXPECT_TRUE(asked.ask(VictimApproach));
    asked.sticks = Ahead;
    EXPECT_EQ(asked.run().driver, Driver::Approacher);
    asked.inputs = {};
    asked.inputs.failed = true;
    decision = asked.run();
    EXPECT_EQ(decision.mode, Teleoperation);
    EXPECT_EQ(decision.driver, Driver::Nobody) << "sticks first";
}

TEST(Modes, TheRemoteHasPriorityAndIsVisible) {
    for (const DriveMode from : {Teleoperation, SafeTeleoperation, Explore, VictimApproach}) {
        Robot robot = robotIn(from);
        robot.sticks = Ahead;
        robot.inputs.remote = DriveVelocity{0.1, 0.0, 0.0};
        ModeDecision decision = robot.run();
        EXPECT_EQ(decision.mode, Remote);
        EXPECT_EQ(decision.driver, Driver::Remote);
        EXPECT_DOUBLE_EQ(decision.velocity.forward, 0.1);
        EXPECT_EQ(robot.machine().sample().mode, "remote");
        EXPECT_EQ(robot.ask(Explore).error().text, "the radio remote is in use");
        robot.link = false;
        EXPECT_EQ(robot.run(5.0).driver, Driver::Remote) << "needs no station";
        robot.link = true;
        robot.inputs.remote.reset();
        decision = robot.run(0.2);
        EXPECT_TRUE(isZero(decision.velocity)) << "at once";
        decision = robot.run(2.0);
        EXPECT_EQ(decision.driver, Driver::Nobody) << "neither the sticks nor the robot go on by themselves";
        EXPECT_TRUE(decision.mode == Teleoperation || decision.mode == SafeTeleoperation);
        EXPECT_NE(robot.drive().driver, Driver::Nobody);
    }
}

TEST(Modes, WhoExploredAllWaits) {
    Robot robot = robotIn(Explore);
    robot.inputs.done = true;
    robot.inputs.report = "nothing is left to explore";
    robot.run();
    robot.inputs = {};
    const ModeDecision decision = robot.run(5.0);
    EXPECT_EQ(decision.driver, Driver::Nobody);
    EXPECT_EQ(decision.reason, "nothing is left to explore");
}

TEST(Modes, TheSampleTellsWhatMayBeAskedFor) {
    Robot robot = robotIn(Explore);
    ModeSample sample = robot.machine().sample();
    EXPECT_EQ(sample.mode, "explore");
    EXPECT_TRUE(sample.autonomous);
    EXPECT_THAT(sample.available, testing::ElementsAre("teleoperation", "safe_teleoperation", "explore"));
    robot.inputs.stopped = true;
    robot.run();
    sample = robot.machine().sample();
    EXPECT_FALSE(sample.autonomous);
    EXPECT_TRUE(sample.available.empty());
}

}  // namespace
}  // namespace leitstand::test
