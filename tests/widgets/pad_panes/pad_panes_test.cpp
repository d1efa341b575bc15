#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/widgets/panes/shown.h"
#include "widgets/pad/pad_legend.h"
#include "widgets/pad/pad_mapping_dialog.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

namespace axis = standard_axis;
namespace button = standard_button;

std::vector<PadCommandFace> commands() {
    return {{"robot.next", "Next robot", "Selects the next robot"},
            {"camera.recentre", "Re-centre cameras", "Cameras look ahead"},
            {"pad.legend", "Controls of the gamepad", "Shows this"},
            {"victim.freeze", "Victim here", "Keeps what the robot sees"},
            {"victim.confirm", "Confirm the find", "Confirms it"},
            {"form.next", "Form: next field", "Of the form"},
            {"form.previous", "Form: previous field", "Of the form"},
            {"form.change", "Form: next choice", "Of the field"},
            {"camera.snapshot", "Take a snapshot", "Keeps the picture"}};
}

PadState driving() {
    PadState pad{.connected = true};
    pad.axes.assign(axis::Count, 0.0);
    pad.buttons.assign(button::Count, false);
    pad.axes[axis::LeftTrigger] = 1.0;
    pad.axes[axis::LeftY] = -0.8;
    pad.axes[axis::LeftX] = 0.3;
    return pad;
}

PadBindings joystick() {
    PadBindings bindings = defaultBindings(PadLayout::Plain);
    EXPECT_TRUE(bindPad(bindings, PadAction::DeadMan, padButton(0)));
    EXPECT_TRUE(bindPad(bindings, PadAction::Stop, padButton(1)));
    EXPECT_TRUE(bindPad(bindings, PadAction::Forward, padAxis(1, -1)));
    EXPECT_TRUE(bindPad(bindings, PadAction::TurnLeft, padAxis(0, -1)));
    EXPECT_TRUE(bindPad(bindings, "robot.next", padButton(6)));
    return bindings;
}

class PadPanesTest : public testing::TestWithParam<Theme> {
protected:
    PadPanesTest() { useTheme(GetParam()); }
    ~PadPanesTest() override { useTheme(Theme::Dark); }
};

TEST_P(PadPanesTest, TheLegendSaysWhatEachControlDoes) {
    PadLegend legend;
    legend.setCommands(commands());
    legend.setPad("Xbox Wireless Controller", defaultBindings(PadLayout::Standard));
    legend.setState(driving());
    (void)pictureOf(legend, legend.sizeHint(), "pad_legend", 2.0);
    EXPECT_EQ(textFaults(legend), QStringList());
    QStringList texts;
    for (const PaintedText& one : paintedTexts(legend)) texts += one.text;
    for (const char* text : {"Hold to drive", "Turbo", "STOP all robots", "drive, turn", "cameras",
                             "Next robot", "Victim here", "Confirm the find", "Form: next field"})
        EXPECT_TRUE(texts.contains(text)) << text << " in " << texts.join(" | ").toStdString();
    legend.resize(640, 400);
    EXPECT_EQ(textFaults(legend), QStringList());
}

TEST_P(PadPanesTest, TheLegendOfAnUnknownJoystickIsAList) {
    PadLegend legend;
    legend.setCommands(commands());
    legend.setPad("Old stick", joystick());
    (void)pictureOf(legend, legend.sizeHint(), "pad_legend_plain");
    EXPECT_EQ(textFaults(legend), QStringList());
}

TEST_P(PadPanesTest, WithoutAPadTheLegendTellsHowToConnectOneAndWhatDrivesUntilThen) {
    PadLegend legend;
    legend.setCommands(commands());
    legend.setPad({}, defaultBindings(PadLayout::Standard));
    (void)pictureOf(legend, legend.sizeHint(), "pad_legend_none");
    EXPECT_EQ(textFaults(legend), QStringList());
    QString all;
    for (const PaintedText& one : paintedTexts(legend)) all += one.text + QLatin1Char(' ');
    for (const char* text : {"Bluetooth", "DualSense", "menu Robot, Gamepad", "F2", "W S A D",
                             "Hold to drive", "STOP all robots"})
        EXPECT_TRUE(all.contains(QLatin1String(text))) << text << " in " << all.toStdString();
    EXPECT_TRUE(all.contains("This is what the controls would do:")) << "to its end: " << all.toStdString();
    EXPECT_TRUE(all.contains("Esc stops all robots, always.")) << "to its end: " << all.toStdString();
}

TEST_P(PadPanesTest, TheDialogShowsControlsAndLiveBars) {
    PadMappingDialog dialog;
    dialog.setCommands(commands());
    dialog.setPads({{1, "Xbox Wireless Controller"}, {2, "Old stick"}}, 1);
    dialog.setBindings(defaultBindings(PadLayout::Standard));
    dialog.setState(driving());
    const QImage picture = pictureOf(dialog, {440, 760}, "pad_dialog", 2.0);
    EXPECT_GT(countOf(picture, coloursOf(GetParam()).select), 500) << "bars of what is pushed";
}

INSTANTIATE_TEST_SUITE_P(Themes, PadPanesTest, testing::Values(Theme::Dark, Theme::Light));

class PadMappingDialogTest : public testing::Test {
protected:
    PadMappingDialogTest() {
        m_dialog.setCommands(commands());
        m_dialog.setPads({{1, "One"}, {2, "Two"}}, 1);
        m_pad = driving();
        m_pad.axes.assign(axis::Count, 0.0);
        m_dialog.setState(m_pad);
        m_dialog.setBindings(defaultBindings(PadLayout::Standard));
        m_dialog.show();
        QObject::connect(&m_dialog, &PadMappingDialog::saved,
                         [this](const PadBindings& bindings) { m_saved.push_back(bindings); });
    }
    [[nodiscard]] QPushButton& push(const QString& text) {
        for (QPushButton* one : m_dialog.findChildren<QPushButton*>()) {
            if (one->text().remove('&') == text) return *one;
        }
        throw std::runtime_error("no button " + text.toStdString());
    }
    void select(int row) { m_dialog.findChild<QTableView*>()->setCurrentIndex(at(row)); }
    [[nodiscard]] QModelIndex at(int row) {
        return m_dialog.findChild<QTableView*>()->model()->index(row, PadTable::Control);
    }

    PadMappingDialog m_dialog;
    PadState m_pad;
    std::vector<PadBindings> m_saved;
};

TEST_F(PadMappingDialogTest, AControlIsPushedAndSaved) {
    EXPECT_FALSE(push("Save").isEnabled());
    select(static_cast<int>(PadAction::Slow));
    push("Set …").click();
    EXPECT_EQ(push("Cancel").isEnabled(), true);
    m_pad.buttons[button::A] = true;
    m_dialog.setState(m_pad);
    EXPECT_EQ(at(static_cast<int>(PadAction::Slow)).data(), "A");
    ASSERT_TRUE(push("Save").isEnabled());
    push("Save").click();
    ASSERT_EQ(m_saved.size(), 1U);
    EXPECT_EQ(m_saved[0].at(PadAction::Slow), padButton(button::A));
    EXPECT_FALSE(push("Save").isEnabled());
}

TEST_F(PadMappingDialogTest, SlidersShapeTheSticks) {
    const auto sliders = m_dialog.findChildren<QSlider*>();
    ASSERT_EQ(sliders.size(), 3);
    sliders[0]->setValue(30);
    push("Save").click();
    ASSERT_EQ(m_saved.size(), 1U);
    EXPECT_DOUBLE_EQ(m_saved[0].deadZone, 0.3);
    push("Usual").click();
    EXPECT_EQ(sliders[0]->value(), 12);
}

TEST_F(PadMappingDialogTest, AnotherPadIsChosen) {
    QSignalSpy chosen(&m_dialog, &PadMappingDialog::padChosen);
    auto* box = m_dialog.findChild<QComboBox*>();
    box->setCurrentIndex(1);
    emit box->activated(1);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen[0][0].toInt(), 2);
}

TEST_F(PadMappingDialogTest, NothingIsSavedWithoutAPad) {
    m_dialog.setPads({}, -1);
    m_dialog.setState({});
    m_dialog.setBindings({});
    EXPECT_FALSE(push("Save").isEnabled());
    EXPECT_FALSE(m_dialog.findChild<QComboBox*>()->isEnabled());
}

TEST_F(PadMappingDialogTest, EverythingHasANameAndAHint) {
    for (QWidget* widget : m_dialog.findChildren<QWidget*>()) {
        if (qobject_cast<QPushButton*>(widget) == nullptr && qobject_cast<QSlider*>(widget) == nullptr)
            continue;
        EXPECT_FALSE(widget->toolTip().isEmpty()) << widget->metaObject()->className();
    }
}

}  // namespace
}  // namespace leitstand::test
