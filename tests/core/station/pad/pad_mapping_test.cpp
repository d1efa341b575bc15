#include "core/station/pad/pad_mapping.h"

#include <limits>

#include <gmock/gmock.h>

#include "core/robot/control/drive_keys.h"

namespace leitstand::test {
namespace {

namespace axis = standard_axis;
namespace button = standard_button;

/// A known pad in the operator's hands.
class PadMappingTest : public testing::Test {
protected:
    PadMappingTest() {
        m_pad.connected = true;
        m_pad.axes.assign(axis::Count, 0.0);
        m_pad.buttons.assign(button::Count, false);
        m_mapping.setLimits({.speed = 0.5, .turnRate = 1.0, .sideways = false});
    }
    PadRequests now(PadScope scope = PadScope::All) { return m_mapping.update(m_pad, scope); }
    void push(int index, double value) { m_pad.axes[static_cast<std::size_t>(index)] = value; }
    void hold(int index, bool held = true) { m_pad.buttons[static_cast<std::size_t>(index)] = held; }
    /// The trigger, as an operator takes it who is about to drive.
    void takeHold() {
        (void)now();
        push(axis::LeftTrigger, 1.0);
        EXPECT_TRUE(isZero(now().drive));
    }

    PadState m_pad;
    PadMapping m_mapping{defaultBindings(PadLayout::Standard)};
};

TEST_F(PadMappingTest, NothingMovesWithoutTheTrigger) {
    (void)now();
    for (const int stick : {axis::LeftX, axis::LeftY, axis::RightTrigger}) {
        push(stick, -1.0);
        EXPECT_TRUE(isZero(now().drive)) << stick;
        EXPECT_FALSE(now().driving);
        push(stick, 0.0);
    }
}

TEST_F(PadMappingTest, TheLeftStickDrivesWhileTheTriggerIsHeld) {
    takeHold();
    EXPECT_TRUE(now().driving);
    push(axis::LeftY, -1.0);
    EXPECT_DOUBLE_EQ(now().drive.forward, DriveKeys::Usual * 0.5) << "up is forward";
    EXPECT_DOUBLE_EQ(now().drive.turn, 0.0);
    push(axis::LeftX, -1.0);
    EXPECT_DOUBLE_EQ(now().drive.turn, DriveKeys::Usual * 1.0) << "left is counter-clockwise";
    push(axis::LeftY, 1.0);
    push(axis::LeftX, 1.0);
    EXPECT_DOUBLE_EQ(now().drive.forward, -DriveKeys::Usual * 0.5);
    EXPECT_DOUBLE_EQ(now().drive.turn, -DriveKeys::Usual * 1.0);
    EXPECT_EQ(now().drive.left, 0.0) << "this robot cannot";
}

TEST_F(PadMappingTest, TurboIsAllAndSlowAQuarterAndWins) {
    takeHold();
    push(axis::LeftY, -1.0);
    push(axis::RightTrigger, 1.0);
    EXPECT_DOUBLE_EQ(now().drive.forward, 0.5);
    hold(button::RightShoulder);
    EXPECT_DOUBLE_EQ(now().drive.forward, DriveKeys::Slowly * 0.5);
}

TEST_F(PadMappingTest, TheLeftShoulderLiftsTheCapWhileItDrives) {
    hold(button::LeftShoulder);
    EXPECT_FALSE(now().withoutEyes) << "nothing drives";
    takeHold();
    EXPECT_TRUE(now().withoutEyes);
    hold(button::LeftShoulder, false);
    EXPECT_FALSE(now().withoutEyes);
}

TEST_F(PadMappingTest, LettingTheTriggerGoIsZeroAtOnceAndTheSticksHaveToBeLetGo) {
    takeHold();
    push(axis::LeftY, -1.0);
    ASSERT_GT(now().drive.forward, 0.0);
    push(axis::LeftTrigger, 0.0);
    EXPECT_TRUE(isZero(now().drive));
    EXPECT_FALSE(now().driving);
    push(axis::LeftTrigger, 1.0);
    EXPECT_TRUE(isZero(now().drive)) << "the stick is still pushed";
    EXPECT_TRUE(now().needsNeutral);
    EXPECT_TRUE(now().driving) << "the sticks are this pad's, and neutral";
    push(axis::LeftY, 0.0);
    (void)now();
    push(axis::LeftY, -1.0);
    EXPECT_GT(now().drive.forward, 0.0);
}

TEST_F(PadMappingTest, ATriggerHeldWhenThePadComesDoesNotCount) {
    push(axis::LeftTrigger, 1.0);
    EXPECT_FALSE(now().driving);
    EXPECT_TRUE(now().needsNeutral);
    push(axis::LeftY, -1.0);
    EXPECT_TRUE(isZero(now().drive));
    push(axis::LeftY, 0.0);
    EXPECT_FALSE(now().driving) << "sticks alone are not enough";
    push(axis::LeftTrigger, 0.0);
    takeHold();
    push(axis::LeftY, -1.0);
    EXPECT_GT(now().drive.forward, 0.0);
}

TEST_F(PadMappingTest, AfterWhateverForbadeDrivingTriggerAndSticksWereNeutral) {
    takeHold();
    push(axis::LeftY, -1.0);
    ASSERT_GT(now().drive.forward, 0.0);
    EXPECT_TRUE(isZero(now(PadScope::Nothing).drive)) << "another window";
    EXPECT_FALSE(now(PadScope::Nothing).driving);
    EXPECT_TRUE(isZero(now().drive)) << "all is held as it was";
    EXPECT_FALSE(now().driving);
    push(axis::LeftTrigger, 0.0);
    (void)now();
    push(axis::LeftTrigger, 1.0);
    EXPECT_TRUE(isZero(now().drive)) << "the stick is still pushed";
    push(axis::LeftY, 0.0);
    (void)now();
    push(axis::LeftY, -1.0);
    EXPECT_GT(now().drive.forward, 0.0);
    m_mapping.needNeutral();
    EXPECT_TRUE(isZero(now().drive));
}

TEST_F(PadMappingTest, LettingTheTriggerGoInAnotherWindowDoesNotHelp) {
    takeHold();
    push(axis::LeftTrigger, 0.0);
    (void)now(PadScope::Nothing);
    push(axis::LeftTrigger, 1.0);
    (void)now(PadScope::Nothing);
    EXPECT_FALSE(now().driving) << "it was pressed for another window";
}

TEST_F(PadMappingTest, APulledPlugIsZeroAndForgetsEverything) {
    takeHold();
    push(axis::LeftY, -1.0);
    ASSERT_GT(now().drive.forward, 0.0);
    m_pad.connected = false;
    EXPECT_EQ(now(), PadRequests{});
    m_pad.connected = true;
    EXPECT_TRUE(isZero(now().drive));
    EXPECT_FALSE(now().driving);
}

TEST_F(PadMappingTest, StopIsOneEdgeAlwaysAndEverywhere) {
    hold(button::B);
    EXPECT_TRUE(now(PadScope::Nothing).stop) << "without trigger and in another window";
    EXPECT_FALSE(now(PadScope::Nothing).stop) << "held";
    hold(button::B, false);
    EXPECT_FALSE(now().stop);
    takeHold();
    push(axis::LeftY, -1.0);
    ASSERT_GT(now().drive.forward, 0.0);
    hold(button::B);
    const PadRequests stopped = now();
    EXPECT_TRUE(stopped.stop);
    EXPECT_TRUE(isZero(stopped.drive));
    EXPECT_FALSE(stopped.driving);
    hold(button::B, false);
    EXPECT_TRUE(isZero(now().drive)) << "trigger and sticks first";
    // Pressed while the pad is plugged in again: it stops.
    m_pad.connected = false;
    (void)now();
    m_pad.connected = true;
    hold(button::B);
    EXPECT_TRUE(now().stop);
}

TEST_F(PadMappingTest, TheRightStickTurnsCamerasWithoutTheTrigger) {
    (void)now();
    push(axis::RightX, -1.0);
    push(axis::RightY, -1.0);
    const double rate = m_mapping.bindings().cameraRate;
    EXPECT_EQ(now().cameras, (PanTiltRate{rate, rate})) << "left and up";
    EXPECT_EQ(now(PadScope::Nothing).cameras, PanTiltRate{});
    EXPECT_EQ(now().cameras, PanTiltRate{}) << "neutral first";
    push(axis::RightX, 0.0);
    push(axis::RightY, 0.0);
    (void)now();
    push(axis::RightX, 1.0);
    EXPECT_EQ(now().cameras, (PanTiltRate{-rate, 0.0}));
}

TEST_F(PadMappingTest, TheRightStickMovesJointsOnlyWhileTheTriggerIsHeldAndFromNeutral) {
    (void)now();
    push(axis::RightY, -1.0);
    EXPECT_EQ(now().joints, 0.0) << "no trigger";
    push(axis::LeftTrigger, 1.0);
    EXPECT_EQ(now().joints, 0.0) << "pushed before the trigger";
    push(axis::RightY, 0.0);
    EXPECT_EQ(now().joints, 0.0);
    push(axis::RightY, -1.0);
    EXPECT_EQ(now().joints, 1.0) << "up";
    push(axis::LeftTrigger, 0.0);
    EXPECT_EQ(now().joints, 0.0) << "the trigger is let go";
    push(axis::LeftTrigger, 1.0);
    EXPECT_EQ(now().joints, 0.0) << "neutral first";
}

TEST_F(PadMappingTest, CommandsArePressedOnceAndOnlyHere) {
    hold(button::Y);
    EXPECT_TRUE(now().commands.empty()) << "held when the pad came";
    hold(button::Y, false);
    (void)now();
    hold(button::Y);
    EXPECT_THAT(now().commands, testing::ElementsAre("robot.next"));
    EXPECT_TRUE(now().commands.empty());
    hold(button::Y, false);
    (void)now(PadScope::Nothing);
    hold(button::Y);
    EXPECT_TRUE(now(PadScope::Nothing).commands.empty());
    EXPECT_TRUE(now().commands.empty()) << "pressed in another window";
}

TEST_F(PadMappingTest, WhileTheRobotIsStoppedCommandsGoOnAndNothingMoves) {
    takeHold();
    push(axis::LeftY, -1.0);
    EXPECT_FALSE(isZero(now().drive));
    push(axis::RightX, -1.0);
    hold(button::Y);
    const PadRequests stopped = now(PadScope::Commands);
    EXPECT_THAT(stopped.commands, testing::ElementsAre("robot.next"));
    EXPECT_TRUE(isZero(stopped.drive));
    EXPECT_FALSE(stopped.driving);
    EXPECT_EQ(stopped.cameras, PanTiltRate{});
    EXPECT_TRUE(isZero(now().drive)) << "trigger and sticks first";
    EXPECT_FALSE(now().driving);
}

TEST_F(PadMappingTest, SticksAreNothingAroundTheirRestAndFineBesideIt) {
    PadBindings bindings = defaultBindings(PadLayout::Standard);
    bindings.deadZone = 0.2;
    bindings.expo = 0.5;
    m_mapping.setBindings(bindings);
    takeHold();
    const auto speedAt = [&](double deflection) {
        push(axis::LeftY, -deflection);
        return now().drive.forward / (DriveKeys::Usual * 0.5);
    };
    EXPECT_EQ(speedAt(0.19), 0.0);
    EXPECT_NEAR(speedAt(0.6), 0.5 * 0.5 + 0.5 * 0.125, 1e-12) << "half the way past the dead zone";
    EXPECT_DOUBLE_EQ(speedAt(1.0), 1.0);
    double before = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const double speed = speedAt(i / 100.0);
        EXPECT_GE(speed, before);
        before = speed;
    }
}

TEST_F(PadMappingTest, ATriggerThatTremblesAtItsPressIsOnePress) {
    (void)now();
    push(axis::LeftTrigger, 0.51);
    EXPECT_TRUE(now().driving);
    push(axis::LeftTrigger, 0.45);
    EXPECT_TRUE(now().driving);
    push(axis::LeftTrigger, 0.39);
    EXPECT_FALSE(now().driving);
}

TEST_F(PadMappingTest, BrokenNumbersAndMissingControlsMoveNothing) {
    takeHold();
    push(axis::LeftY, std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(isZero(now().drive));
    push(axis::LeftY, -1'000.0);
    EXPECT_DOUBLE_EQ(now().drive.forward, DriveKeys::Usual * 0.5);
    m_pad.axes.clear();
    m_pad.buttons.clear();
    EXPECT_EQ(now(), PadRequests{}) << "a pad with fewer controls than are bound";
}

TEST_F(PadMappingTest, AnUnknownJoystickMovesNothingUntilItIsBound) {
    m_mapping.setBindings(defaultBindings(PadLayout::Plain));
    for (double& one : m_pad.axes) one = 1.0;
    m_pad.buttons.assign(m_pad.buttons.size(), true);
    EXPECT_EQ(now(), PadRequests{});
    // A joystick with one trigger button and a throttle that rests at its lower end.
    PadBindings bindings = defaultBindings(PadLayout::Plain);
    ASSERT_TRUE(bindPad(bindings, PadAction::DeadMan, padButton(0)));
    ASSERT_TRUE(bindPad(bindings, PadAction::Forward, padAxis(3, 1, -1.0)));
    m_mapping.setBindings(bindings);
    m_pad.buttons.assign(2, false);
    m_pad.axes = {0.0, 0.0, 0.0, -1.0};
    (void)now();
    hold(0);
    ASSERT_TRUE(isZero(now().drive));
    push(3, 1.0);
    EXPECT_DOUBLE_EQ(now().drive.forward, DriveKeys::Usual * 0.5);
}

}  // namespace
}  // namespace leitstand::test
