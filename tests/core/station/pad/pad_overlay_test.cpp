#include "core/station/pad/pad_overlay.h"

#include <gmock/gmock.h>

namespace leitstand::test {
namespace {

TEST(PadOverlay, ALayoutsButtonsGoBeforeTheOperators) {
    const PadBindings own = defaultBindings(PadLayout::Standard);
    const PadOverlay overlay = withCommands(own, {{"y", "camera.snapshot"}, {"up", "robot.next"}});
    EXPECT_TRUE(overlay.refused.empty());
    EXPECT_EQ(controlOf(overlay.bindings, "camera.snapshot"), padButton(standard_button::Y));
    EXPECT_EQ(controlOf(overlay.bindings, "robot.next"), padButton(standard_button::Up));
    EXPECT_EQ(controlOf(overlay.bindings, "camera.recentre"), controlOf(own, "camera.recentre"));
    EXPECT_EQ(withCommands(own, {}).bindings, own);
}

TEST(PadOverlay, DrivingAndStopStayWhereTheyAre) {
    const PadBindings own = defaultBindings(PadLayout::Standard);
    const PadOverlay overlay = withCommands(
        own,
        {{"b", "robot.next"}, {"right_shoulder", "robot.next"}, {"z", "robot.next"}, {"", "robot.next"}});
    EXPECT_THAT(overlay.refused, testing::UnorderedElementsAre("b", "right_shoulder", "z", ""));
    EXPECT_EQ(overlay.bindings, own);
}

TEST(PadOverlay, ButtonsHaveNamesOrNumbers) {
    EXPECT_EQ(padButtonNamed("left_shoulder", PadLayout::Standard), padButton(standard_button::LeftShoulder));
    EXPECT_EQ(padButtonNamed("right", PadLayout::Standard), padButton(standard_button::Right));
    EXPECT_EQ(padButtonNamed("right", PadLayout::Plain), std::nullopt);
    EXPECT_EQ(padButtonNamed("button 7", PadLayout::Plain), padButton(6));
    for (const char* none : {"button 0", "button -1", "button 129", "button ", "button 1x", "button", "A"})
        EXPECT_EQ(padButtonNamed(none, PadLayout::Plain), std::nullopt) << none;
}

}  // namespace
}  // namespace leitstand::test
