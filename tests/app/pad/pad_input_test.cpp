#include "app/window/live/pad/pad_input.h"

#include <atomic>
#include <optional>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gmock/gmock.h>

#include "tests/app/pad/virtual_pad.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

namespace axis = standard_axis;
namespace button = standard_button;

constexpr int Patience = 10'000;  ///< [ms]

/// The gamepads of a window, which has the focus.
class PadInputTest : public testing::Test {
protected:
    PadInputTest() {
        m_pad.emplace();
        start();
        EXPECT_TRUE(
            soon([this] { return m_input->chosen().name == "Test pad" && m_input->state().connected; }));
    }
    void start() {
        m_input.reset();
        PadInputSettings settings;
        settings.memory = PadMemory(m_folder.filePath("pads").toStdString());
        settings.onStop = [this] { ++m_stopsOnThread; };
        m_input = std::make_unique<PadInput>(settings);
        m_input->setLimits({.speed = 0.5, .turnRate = 1.0, .sideways = false});
        m_input->setScope(PadScope::All);
        QObject::connect(m_input.get(), &PadInput::sticks,
                         [this](const DriveVelocity& velocity, bool driving) {
                             m_sticks = velocity;
                             m_driving = driving;
                         });
        QObject::connect(m_input.get(), &PadInput::needsNeutral,
                         [this](bool needs) { m_needsNeutral = needs; });
        QObject::connect(m_input.get(), &PadInput::panTilt,
                         [this](const PanTiltRate& rate) { m_cameras = rate; });
        QObject::connect(m_input.get(), &PadInput::commandWanted,
                         [this](const QString& id) { m_commands += id; });
        QObject::connect(m_input.get(), &PadInput::stopPressed, [this] { ++m_stops; });
    }
    template <class Holds>
    [[nodiscard]] static bool soon(Holds holds) {
        return QTest::qWaitFor(holds, Patience);
    }
    /// The state of the chosen pad is what the virtual one was told.
    [[nodiscard]] bool arrives(int axisIndex, double value) {
        m_pad->push(axisIndex, value);
        return soon([&] { return std::abs(m_input->state().axis(axisIndex) - value) < 0.01; });
    }
    void drive() {
        ASSERT_TRUE(soon([&] { return m_input->state().axis(axis::LeftTrigger) < 0.01; }));
        ASSERT_TRUE(arrives(axis::LeftTrigger, 1.0));
        ASSERT_TRUE(soon([&] { return m_driving; }));
        ASSERT_TRUE(arrives(axis::LeftY, -1.0));
        ASSERT_TRUE(soon([&] { return m_sticks.forward > 0.2; }));
    }

    const QTemporaryDir m_folder;
    std::optional<VirtualPad> m_pad;
    std::unique_ptr<PadInput> m_input;
    DriveVelocity m_sticks;
    bool m_driving = false, m_needsNeutral = false;
    PanTiltRate m_cameras;
    QStringList m_commands;
    int m_stops = 0;
    std::atomic<int> m_stopsOnThread = 0;
};

TEST_F(PadInputTest, DrivesWhileTheTriggerIsHeld) {
    ASSERT_TRUE(arrives(axis::LeftY, -1.0));
    EXPECT_TRUE(isZero(m_sticks)) << "no trigger";
    ASSERT_TRUE(arrives(axis::LeftY, 0.0));
    drive();
    EXPECT_NEAR(m_sticks.forward, 0.3, 1e-6) << "60 %";
    ASSERT_TRUE(arrives(axis::RightTrigger, 1.0));
    EXPECT_TRUE(soon([&] { return m_sticks.forward > 0.499; })) << "turbo";
    QSignalSpy reported(m_input.get(), &PadInput::sticks);
    ASSERT_TRUE(soon([&] { return reported.count() >= 5; })) << "again and again while it is held";
    ASSERT_TRUE(arrives(axis::LeftTrigger, 0.0));
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_FALSE(m_driving);
    ASSERT_TRUE(arrives(axis::LeftTrigger, 1.0));
    EXPECT_TRUE(isZero(m_sticks)) << "the stick is still pushed";
    EXPECT_TRUE(m_needsNeutral);
}

TEST_F(PadInputTest, AnUnpluggedPadStopsAndANewOneStartsNeutral) {
    drive();
    QSignalSpy gone(m_input.get(), &PadInput::gone);
    m_pad.reset();
    ASSERT_TRUE(soon([&] { return gone.count() == 1; }));
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_FALSE(m_driving);
    EXPECT_EQ(m_input->chosen().id, -1);
    // Plugged in again with all held.
    m_pad.emplace(PadLayout::Standard, "Test pad",
                  std::vector<std::pair<int, double>>{{axis::LeftTrigger, 1.0}, {axis::LeftY, -1.0}});
    ASSERT_TRUE(soon([&] { return m_input->state().axis(axis::LeftY) < -0.99; }));
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_FALSE(m_driving);
    ASSERT_TRUE(arrives(axis::LeftTrigger, 0.0));
    ASSERT_TRUE(arrives(axis::LeftY, 0.0));
    drive();
}

TEST_F(PadInputTest, StopIsToldAtOnceEvenWhileTheWindowIsBusy) {
    m_input->setScope(PadScope::Nothing);
    m_pad->press(button::B);
    // Nothing is done on this thread.
    ASSERT_TRUE(waitUntil([&] { return m_stopsOnThread == 1; }));
    EXPECT_EQ(m_stops, 0);
    EXPECT_TRUE(soon([&] { return m_stops == 1; }));
    m_pad->press(button::B, false);
    ASSERT_TRUE(soon([&] { return !m_input->state().button(button::B); }));
    m_pad->press(button::B);
    EXPECT_TRUE(soon([&] { return m_stops == 2 && m_stopsOnThread == 2; }));
}

TEST_F(PadInputTest, AfterStopTriggerAndSticksHaveToBeLetGo) {
    drive();
    m_pad->press(button::B);
    ASSERT_TRUE(soon([&] { return m_stops == 1; }));
    m_pad->press(button::B, false);
    ASSERT_TRUE(soon([&] { return !m_input->state().button(button::B); }));
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_FALSE(m_driving);
    ASSERT_TRUE(arrives(axis::LeftTrigger, 0.0));
    ASSERT_TRUE(arrives(axis::LeftY, 0.0));
    drive();
}

TEST_F(PadInputTest, WithoutTheWindowsFocusOnlyStopWorks) {
    drive();
    m_input->setScope(PadScope::Nothing);
    EXPECT_TRUE(isZero(m_sticks)) << "at once";
    EXPECT_FALSE(m_driving);
    m_pad->press(button::Y);
    ASSERT_TRUE(arrives(axis::RightX, 1.0));
    ASSERT_TRUE(soon([&] { return m_input->state().button(button::Y); }));
    EXPECT_TRUE(m_commands.empty());
    EXPECT_EQ(m_cameras, PanTiltRate{});
    m_pad->press(button::B);
    EXPECT_TRUE(soon([&] { return m_stops == 1; }));
    m_input->setScope(PadScope::All);
    EXPECT_FALSE(m_driving) << "all is held as it was";
}

TEST_F(PadInputTest, CamerasTurnAndCommandsArePressed) {
    ASSERT_TRUE(arrives(axis::RightX, -1.0));
    EXPECT_GT(m_cameras.pan, 0.5) << "left";
    ASSERT_TRUE(arrives(axis::RightX, 0.0));
    EXPECT_EQ(m_cameras, PanTiltRate{});
    m_pad->press(button::Y);
    EXPECT_TRUE(soon([&] { return m_commands == QStringList{"robot.next"}; }));
    m_pad->press(button::Y, false);
    m_pad->press(button::Back);
    EXPECT_TRUE(soon([&] { return m_commands.size() == 2 && m_commands.back() == "pad.legend"; }));
}

TEST_F(PadInputTest, OfSeveralPadsTheFirstDrivesAndAllStop) {
    VirtualPad second(PadLayout::Standard, "Second pad");
    ASSERT_TRUE(soon([&] { return m_input->pads().size() == 2; }));
    EXPECT_EQ(m_input->chosen().name, "Test pad");
    second.press(button::B);
    EXPECT_TRUE(soon([&] { return m_stops == 1; }));
    second.press(button::B, false);
    second.push(axis::LeftTrigger, 1.0);
    drive();
    m_input->choose(m_input->pads()[1].id);
    EXPECT_TRUE(isZero(m_sticks)) << "another one has the sticks";
    EXPECT_FALSE(m_driving) << "its trigger is held since before";
    m_pad.reset();
    ASSERT_TRUE(soon([&] { return m_input->pads().size() == 1; }));
    EXPECT_EQ(m_input->chosen().name, "Second pad");
}

TEST_F(PadInputTest, WhenThePadThatDrivesGoesTheOtherTakesOverNeutral) {
    VirtualPad second(PadLayout::Standard, "Second pad");
    ASSERT_TRUE(soon([&] { return m_input->pads().size() == 2; }));
    second.push(axis::LeftTrigger, 1.0);
    second.push(axis::LeftY, -1.0);
    drive();
    m_pad.reset();
    ASSERT_TRUE(soon([&] { return m_input->chosen().name == "Second pad"; }));
    EXPECT_TRUE(isZero(m_sticks));
    EXPECT_FALSE(m_driving);
}

TEST_F(PadInputTest, WhatIsBoundIsKeptForThisKindOfPad) {
    PadBindings bindings = m_input->bindings();
    ASSERT_TRUE(bindPad(bindings, PadAction::Stop, padButton(button::A)));
    m_input->setBindings(bindings);
    m_pad->press(button::A);
    ASSERT_TRUE(soon([&] { return m_stops == 1; }));
    m_pad->press(button::A, false);
    start();
    ASSERT_TRUE(soon([&] { return m_input->chosen().id >= 0; }));
    EXPECT_EQ(m_input->bindings(), bindings);
    m_input->setLayoutCommands({{"x", "map.top"}, {"a", "map.top"}});
    EXPECT_EQ(controlOf(m_input->bindings(), "map.top"), padButton(button::X)) << "A stops";
    EXPECT_EQ(m_input->ownBindings(), bindings);
}

TEST_F(PadInputTest, AnUnknownJoystickSaysSoAndCanBeBound) {
    QSignalSpy reported(m_input.get(), &PadInput::notified);
    m_pad.reset();
    VirtualPad stick(PadLayout::Plain, "Old stick");
    ASSERT_TRUE(soon([&] { return m_input->chosen().name == "Old stick" && reported.count() == 1; }));
    EXPECT_THAT(reported[0][0].toString().toStdString(), testing::HasSubstr("Old stick"));
    EXPECT_EQ(m_input->chosen().layout, PadLayout::Plain);
    PadBindings bindings = m_input->bindings();
    ASSERT_TRUE(bindPad(bindings, PadAction::DeadMan, padButton(0)));
    ASSERT_TRUE(bindPad(bindings, PadAction::Forward, padButton(8)));  // the hat, upwards
    m_input->setBindings(bindings);
    stick.press(0);
    ASSERT_TRUE(soon([&] { return m_driving; }));
    stick.hat(1);
    EXPECT_TRUE(soon([&] { return m_sticks.forward > 0.2; }));
    stick.hat(0);
    EXPECT_TRUE(soon([&] { return isZero(m_sticks); }));
}

TEST_F(PadInputTest, EveryPressOfStopIsToldOnce) {
    for (int i = 1; i <= 20; ++i) {
        m_pad->press(button::B);
        ASSERT_TRUE(waitUntil([&] { return m_stopsOnThread == i; }));
        m_pad->press(button::B, false);
        ASSERT_TRUE(soon([&] { return m_stops == i && !m_input->state().button(button::B); }));
    }
}

TEST_F(PadInputTest, ThePadTrembles) {
    m_input->rumble(0.7, 50);
    EXPECT_TRUE(soon([&] { return m_pad->rumbles() > 0; }));
}

}  // namespace
}  // namespace leitstand::test
