#include "widgets/models/pad/pad_table.h"

#include <QSignalSpy>

#include <gmock/gmock.h>

namespace leitstand::test {
namespace {

namespace axis = standard_axis;
namespace button = standard_button;

PadState atRest() {
    PadState pad{.connected = true};
    pad.axes.assign(axis::Count, 0.0);
    pad.buttons.assign(button::Count, false);
    return pad;
}

int rowOf(const PadTable& table, const QString& does) {
    for (int row = 0; row < table.rowCount(); ++row) {
        if (table.index(row, PadTable::Action).data() == does) return row;
    }
    return -1;
}

class PadTableTest : public testing::Test {
protected:
    PadTableTest() {
        m_table.setCommands(
            {{"robot.next", "Next robot", "Selects the next robot"}, {"look.top", "Top view", ""}});
        m_table.setBindings(defaultBindings(PadLayout::Standard));
        m_table.setState(m_pad);
    }
    [[nodiscard]] QString controlOf(const QString& does) const {
        return m_table.index(rowOf(m_table, does), PadTable::Control).data().toString();
    }
    void press(int index, bool held = true) {
        m_pad.buttons[static_cast<std::size_t>(index)] = held;
        m_table.setState(m_pad);
    }

    PadState m_pad = atRest();
    PadTable m_table;
};

TEST_F(PadTableTest, TellsWhichControlDoesWhat) {
    EXPECT_EQ(controlOf("Forward"), "Left stick up");
    EXPECT_EQ(controlOf("Hold to drive"), "Left trigger");
    EXPECT_EQ(controlOf("STOP all robots"), "B");
    EXPECT_EQ(controlOf("Next robot"), "Y");
    EXPECT_EQ(controlOf("Top view"), "–");
    const int row = rowOf(m_table, "Next robot");
    EXPECT_EQ(m_table.index(row, 0).data(Qt::ToolTipRole), "Selects the next robot");
}

TEST_F(PadTableTest, TheControlThatIsPushedIsTheRows) {
    m_table.capture(rowOf(m_table, "Top view"));
    EXPECT_EQ(controlOf("Top view"), "push it now …");
    EXPECT_FALSE(m_table.isChanged());
    press(button::X);
    EXPECT_EQ(controlOf("Top view"), "X");
    EXPECT_TRUE(m_table.isChanged());
    EXPECT_EQ(m_table.captured(), -1);
    press(button::X, false);
    press(button::A);
    EXPECT_EQ(controlOf("Top view"), "X") << "one push, one control";
    m_table.clear(rowOf(m_table, "Top view"));
    EXPECT_EQ(controlOf("Top view"), "–");
}

TEST_F(PadTableTest, TheButtonThatStopsIsRefused) {
    QSignalSpy refused(&m_table, &PadTable::refused);
    m_table.capture(rowOf(m_table, "Slow"));
    press(button::B);
    EXPECT_EQ(refused.count(), 1);
    EXPECT_EQ(controlOf("Slow"), "Right shoulder");
    EXPECT_FALSE(m_table.canClear(rowOf(m_table, "STOP all robots")));
}

TEST_F(PadTableTest, UnpluggingEndsTheWaiting) {
    m_table.capture(0);
    m_table.setState({});
    EXPECT_EQ(m_table.captured(), -1);
}

TEST_F(PadTableTest, HowFarAControlIsPushedIsToldOfItsRowAlone) {
    QSignalSpy reported(&m_table, &PadTable::dataChanged);
    m_pad.axes[axis::LeftY] = -0.5;
    m_table.setState(m_pad);
    ASSERT_EQ(reported.count(), 1);
    const QModelIndex at = m_table.index(rowOf(m_table, "Forward"), PadTable::Control);
    EXPECT_EQ(reported[0][0].toModelIndex(), at);
    EXPECT_DOUBLE_EQ(at.data(PadTable::AmountRole).toDouble(), 0.5);
}

TEST_F(PadTableTest, WithoutStopTheBindingsAreNotFitForUse) {
    EXPECT_EQ(m_table.fault(), "");
    m_table.setBindings(defaultBindings(PadLayout::Plain));
    EXPECT_NE(m_table.fault(), "");
    EXPECT_FALSE(m_table.isChanged());
}

TEST_F(PadTableTest, ResetIsWhatPadsUsuallyDo) {
    m_table.clear(rowOf(m_table, "Next robot"));
    m_table.setShape(0.3, 0.0, 0.9);
    m_table.reset();
    EXPECT_EQ(m_table.bindings(), defaultBindings(PadLayout::Standard));
    EXPECT_FALSE(m_table.isChanged());
}

TEST(PadTexts, ControlsOfUnknownJoysticksAreNumberedFromOne) {
    EXPECT_EQ(padControlName(padButton(0), PadLayout::Plain), "Button 1");
    EXPECT_EQ(padControlName(padAxis(2, -1), PadLayout::Plain), "Axis 3 −");
    EXPECT_EQ(padControlName(padButton(40), PadLayout::Standard), "Button 41");
    EXPECT_EQ(padControlName(padAxis(9, 1), PadLayout::Standard), "Axis 10 +");
    for (int i = 0; i < button::Count; ++i)
        EXPECT_FALSE(padControlName(padButton(i), PadLayout::Standard).startsWith("Button")) << i;
    for (int i = 0; i < axis::Count; ++i)
        EXPECT_FALSE(padControlName(padAxis(i, 1), PadLayout::Standard).startsWith("Axis")) << i;
}

TEST(PadTexts, EveryActionHasANameAndAHint) {
    for (const PadAction action : padActions()) {
        EXPECT_FALSE(padActionName(action).isEmpty());
        EXPECT_FALSE(padActionHint(action).isEmpty());
    }
    EXPECT_TRUE(padDriveHint(defaultBindings(PadLayout::Standard)).contains("Left trigger"));
    EXPECT_TRUE(padDriveHint(defaultBindings(PadLayout::Plain)).contains("Nothing moves"));
}

}  // namespace
}  // namespace leitstand::test
