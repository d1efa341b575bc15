#include <algorithm>

#include <gtest/gtest.h>

#include "core/station/pad/pad_capture.h"

namespace leitstand::test {
namespace {

using Kind = PadControl::Kind;

TEST(PadBindings, BothEndsOfAStickAreBoundTogether) {
    PadBindings bindings = defaultBindings(PadLayout::Plain);
    ASSERT_TRUE(bindPad(bindings, PadAction::Forward, padAxis(1, -1)));
    EXPECT_EQ(bindings.at(PadAction::Back), padAxis(1, 1));
    ASSERT_TRUE(bindPad(bindings, PadAction::Back, padButton(4)));
    EXPECT_EQ(bindings.at(PadAction::Forward), padAxis(1, -1)) << "a button has no other end";
    ASSERT_TRUE(bindPad(bindings, PadAction::Back, padAxis(5, 1, -1.0)));
    EXPECT_EQ(bindings.at(PadAction::Forward), padAxis(1, -1)) << "a trigger neither";
}

TEST(PadBindings, AControlDoesOneThing) {
    PadBindings bindings = defaultBindings(PadLayout::Standard);
    ASSERT_TRUE(bindPad(bindings, PadAction::Slow, padButton(standard_button::Y)));
    EXPECT_EQ(controlOf(bindings, "robot.next").kind, Kind::None);
    ASSERT_TRUE(bindPad(bindings, "robot.next", padButton(standard_button::Y)));
    EXPECT_EQ(bindings.at(PadAction::Slow).kind, Kind::None);
    ASSERT_TRUE(bindPad(bindings, "robot.next", padButton(standard_button::X)));
    EXPECT_EQ(controlOf(bindings, "robot.next"), padButton(standard_button::X)) << "moved, not doubled";
    ASSERT_TRUE(bindPad(bindings, PadAction::PanLeft, padAxis(standard_axis::LeftY, 1)));
    EXPECT_EQ(bindings.at(PadAction::Forward).kind, Kind::None);
    EXPECT_EQ(bindings.at(PadAction::Back).kind, Kind::None);
    EXPECT_EQ(bindings.at(PadAction::PanRight), padAxis(standard_axis::LeftY, -1));
}

TEST(PadBindings, NobodyTakesTheControlThatStops) {
    PadBindings bindings = defaultBindings(PadLayout::Standard);
    const PadBindings before = bindings;
    EXPECT_FALSE(bindPad(bindings, PadAction::Turbo, padButton(standard_button::B)));
    EXPECT_FALSE(bindPad(bindings, "robot.next", padButton(standard_button::B)));
    EXPECT_EQ(bindings, before);
    ASSERT_TRUE(bindPad(bindings, PadAction::Stop, padAxis(7, 1)));
    EXPECT_FALSE(bindPad(bindings, PadAction::Forward, padAxis(7, -1))) << "its other end would go back";
    EXPECT_TRUE(bindPad(bindings, PadAction::Stop, padButton(standard_button::A)));
}

TEST(PadBindings, EveryActionHasANameOfItsOwnAndOppositesAreMutual) {
    std::vector<std::string> names;
    for (const PadAction action : padActions()) {
        names.push_back(toString(action));
        if (const auto other = oppositeOf(action)) {
            EXPECT_EQ(oppositeOf(*other), action);
        }
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

TEST(PadBindings, AKnownPadDrivesAndStopsFromTheBox) {
    const PadBindings bindings = defaultBindings(PadLayout::Standard);
    for (const PadAction action :
         {PadAction::DeadMan, PadAction::Forward, PadAction::Back, PadAction::TurnLeft, PadAction::TurnRight,
          PadAction::Turbo, PadAction::Slow, PadAction::Stop}) {
        EXPECT_NE(bindings.at(action).kind, Kind::None) << toString(action);
    }
}

TEST(PadBindings, AKnownPadFilesAVictimAndFillsInItsFormFromTheBox) {
    const PadBindings bindings = defaultBindings(PadLayout::Standard);
    namespace button = standard_button;
    EXPECT_EQ(controlOf(bindings, "victim.freeze"), padButton(button::X));
    EXPECT_EQ(controlOf(bindings, "victim.confirm"), padButton(button::A));
    EXPECT_EQ(controlOf(bindings, "form.next"), padButton(button::Down));
    EXPECT_EQ(controlOf(bindings, "form.previous"), padButton(button::Up));
    EXPECT_EQ(controlOf(bindings, "form.change"), padButton(button::Right));
}

TEST(PadBindings, NoControlOfAKnownPadDoesTwoThings) {
    const PadBindings bindings = defaultBindings(PadLayout::Standard);
    std::vector<PadControl> taken(bindings.controls.begin(), bindings.controls.end());
    for (const PadCommand& one : bindings.commands) taken.push_back(one.control);
    std::erase_if(taken, [](const PadControl& one) { return one.kind == Kind::None; });
    ASSERT_GT(taken.size(), 20U);
    for (std::size_t i = 0; i < taken.size(); ++i)
        EXPECT_EQ(std::count(taken.begin(), taken.end(), taken[i]), 1) << i;
}

PadState joystick() {
    PadState pad;
    pad.connected = true;
    pad.axes = {0.03, -0.02, -1.0, 1.0};
    pad.buttons.assign(6, false);
    return pad;
}

TEST(PadCapture, FindsButtonsAndEndsOfAxes) {
    PadState pad = joystick();
    PadCapture capture(pad);
    EXPECT_EQ(capture.update(pad), std::nullopt);
    pad.buttons[5] = true;
    EXPECT_EQ(capture.update(pad), padButton(5));
    pad = joystick();
    pad.axes[1] = -0.9;
    EXPECT_EQ(capture.update(pad), padAxis(1, -1));
    pad = joystick();
    pad.axes[0] = 0.9;
    EXPECT_EQ(capture.update(pad), padAxis(0, 1));
}

TEST(PadCapture, KnowsTriggersByWhereTheyRest) {
    PadState pad = joystick();
    PadCapture capture(pad);
    pad.axes[2] = 0.5;
    EXPECT_EQ(capture.update(pad), padAxis(2, 1, -1.0));
    pad = joystick();
    pad.axes[3] = -1.0;
    EXPECT_EQ(capture.update(pad), padAxis(3, -1, 1.0));
}

TEST(PadCapture, ALittleIsNothingAndTheFurthestCounts) {
    PadState pad = joystick();
    PadCapture capture(pad);
    pad.axes[0] = 0.5;
    pad.axes[1] = 0.4;
    EXPECT_EQ(capture.update(pad), std::nullopt);
    pad.axes[0] = 0.7;
    pad.axes[1] = -0.95;
    EXPECT_EQ(capture.update(pad), padAxis(1, -1));
}

TEST(PadCapture, AButtonThatWasHeldCountsOnceItWasLetGo) {
    PadState pad = joystick();
    pad.buttons[2] = true;
    PadCapture capture(pad);
    EXPECT_EQ(capture.update(pad), std::nullopt);
    pad.buttons[2] = false;
    EXPECT_EQ(capture.update(pad), std::nullopt);
    pad.buttons[2] = true;
    EXPECT_EQ(capture.update(pad), padButton(2));
}

}  // namespace
}  // namespace leitstand::test
