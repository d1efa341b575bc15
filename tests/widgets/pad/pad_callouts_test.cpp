#include "widgets/models/pad/pad_callouts.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

const std::vector<PadCommandFace> Commands = {{"robot.next", "Next robot", ""}};

const PadCallout& of(const std::vector<PadCallout>& all, const QString& control) {
    return *std::find_if(all.begin(), all.end(),
                         [&](const PadCallout& one) { return one.control == control; });
}

TEST(PadCallouts, SayInAWordWhatEachControlDoes) {
    const PadCallouts callouts = padCallouts(defaultBindings(PadLayout::Standard), Commands, {});
    EXPECT_EQ(of(callouts.left, "Left stick").does, "drive, turn");
    EXPECT_EQ(of(callouts.right, "Right stick").does, "cameras");
    EXPECT_EQ(of(callouts.left, "Left trigger").does, "Hold to drive");
    EXPECT_EQ(of(callouts.right, "Y").does, "Next robot");
    EXPECT_EQ(of(callouts.right, "A").does, "");
    EXPECT_TRUE(of(callouts.right, "B").stop);
    EXPECT_EQ(of(callouts.right, "Right stick pressed").does, "") << "a command that this window has not";
}

TEST(PadCallouts, WhatIsHeldIsSeen) {
    PadState state{.connected = true};
    state.axes.assign(6, 0.0);
    state.buttons.assign(15, false);
    state.axes[standard_axis::LeftTrigger] = 0.9;
    state.buttons[standard_button::Y] = true;
    const PadCallouts callouts = padCallouts(defaultBindings(PadLayout::Standard), Commands, state);
    EXPECT_TRUE(of(callouts.left, "Left trigger").held);
    EXPECT_TRUE(of(callouts.right, "Y").held);
    EXPECT_FALSE(of(callouts.left, "Left stick").held);
}

TEST(PadCallouts, OfAnUnknownJoystickEveryControlIsListed) {
    PadBindings bindings = defaultBindings(PadLayout::Plain);
    EXPECT_TRUE(padList(bindings, Commands, {}).empty());
    ASSERT_TRUE(bindPad(bindings, PadAction::Stop, padButton(3)));
    ASSERT_TRUE(bindPad(bindings, PadAction::Forward, padAxis(1, -1)));
    ASSERT_TRUE(bindPad(bindings, "robot.next", padButton(0)));
    const auto list = padList(bindings, Commands, {});
    ASSERT_EQ(list.size(), 4U);
    EXPECT_EQ(of(list, "Button 4").does, "STOP all robots");
    EXPECT_EQ(of(list, "Axis 2 +").does, "Back");
    EXPECT_EQ(of(list, "Button 1").does, "Next robot");
}

}  // namespace
}  // namespace leitstand::test
