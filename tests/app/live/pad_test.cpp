#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>

#include <gmock/gmock.h>

#include "app/services/station/cameras/station_cameras.h"
#include "app/services/station/safety/station_alarms.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/drive_input.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/live/pad/pad_input.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/live_page.h"
#include "tests/app/pad/virtual_pad.h"
#include "widgets/pad/pad_legend.h"
#include "widgets/pad/pad_mapping_dialog.h"
#include "widgets/preflight/preflight_page.h"
#include "widgets/victims/victim_form.h"

namespace leitstand::test {
namespace {

namespace axis = standard_axis;
namespace button = standard_button;
using Clock = std::chrono::steady_clock;

/// The live window with a gamepad, on both simulated robots.
class PadDriveTest : public LivePage {
protected:
    PadDriveTest() { plugIn(); }
    void plugIn() {
        m_pad.emplace();
        EXPECT_TRUE(soon([this] { return word().contains("Test pad is plugged in"); }))
            << word().toStdString();
    }
    /// Said lately: another message may come at once.
    [[nodiscard]] QString word() const { return m_window->recent().join("; "); }
    /// As the operator does it: the trigger, and the stick once the robot may move.
    void drive() {
        ASSERT_TRUE(soon([&] { return robot().link.state == LinkState::Connected; }));
        m_pad->push(axis::LeftTrigger, 1.0);
        ASSERT_TRUE(soon([&] {
            const DriveView drive = robot().drive;
            return drive.driving && drive.listening && !drive.needsNeutral;
        }));
        // On a busy machine pictures come late, and a robot whose driver sees little creeps: without eyes it
        // does not. Sticks are let go first where it stood for that.
        m_pad->press(button::LeftShoulder);
        ASSERT_TRUE(soon([&] {
            m_pad->push(axis::LeftY, robot().drive.needsNeutral ? 0.0 : -1.0);
            return speed() > 0.1;
        })) << toString(robot().link.reasons)
            << " driving " << robot().drive.driving << ", sight " << robot().drive.sight.factor << " after "
            << robot().drive.sight.age << " s";
        m_pad->press(button::LeftShoulder, false);
    }
    void letGo() {
        m_pad->push(axis::LeftY, 0.0);
        m_pad->push(axis::LeftTrigger, 0.0);
        const auto* input = m_window->findChild<PadInput*>();
        ASSERT_TRUE(soon([&] {
            const PadState state = input->state();
            return state.axis(axis::LeftTrigger) < 0.01 && std::abs(state.axis(axis::LeftY)) < 0.01;
        }));
    }
    /// Pushes a button and lets it go, each for as long as the program needs to see it.
    void tap(int which) {
        const auto* input = m_window->findChild<PadInput*>();
        for (const bool held : {true, false}) {
            m_pad->press(which, held);
            ASSERT_TRUE(soon([&] { return input->state().button(which) == held; })) << which;
        }
    }
    /// The first victim as the mission has it.
    [[nodiscard]] std::optional<FindSample> victim() const {
        const MissionStatePtr mission = station().mission();
        const auto found = mission->finds->find({FindSample::Kind::Victim, 1});
        return found == mission->finds->end() ? std::nullopt : std::optional(found->second.victim);
    }
    /// How long until the robot is commanded to stand [ms].
    [[nodiscard]] double untilZero(Clock::time_point since) {
        EXPECT_TRUE(soon([&] { return isZero(robot().drive.velocity); }));
        return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
    }

    std::optional<VirtualPad> m_pad;
};

TEST_F(PadDriveTest, DrivesWhileItsTriggerIsHeldAndUnpluggingStopsTheRobot) {
    drive();
    EXPECT_TRUE(m_window->driving());
    auto since = Clock::now();
    m_pad->push(axis::LeftTrigger, 0.0);
    EXPECT_LT(untilZero(since), 500.0);
    ASSERT_TRUE(soon([&] { return std::abs(speed()) < 0.02; }));
    EXPECT_FALSE(m_window->driving());
    letGo();
    drive();
    since = Clock::now();
    m_pad.reset();
    const double zero = untilZero(since);
    ASSERT_TRUE(soon([&] { return std::abs(speed()) < 0.02; }));
    const double stands = std::chrono::duration<double, std::milli>(Clock::now() - since).count();
    std::cout << "unplugged: told to stand after " << zero << " ms, stands after " << stands << " ms\n";
    EXPECT_LT(zero, 500.0);
    EXPECT_TRUE(soon([&] { return word().contains("unplugged"); }));
}

TEST_F(PadDriveTest, ThePreflightNamesThePadThatDrives) {
    press(Qt::Key_F9);
    const auto* const page = m_window->findChild<PreflightPage*>();
    const auto pad = [&] {
        const auto& checks = page->list().checks();
        const auto line = std::find_if(checks.begin(), checks.end(), [](const PreflightCheck& one) {
            return one.kind == PreflightCheck::Kind::Gamepad || one.kind == PreflightCheck::Kind::GamepadNone;
        });
        return line == checks.end() ? std::string("no line") : line->detail;
    };
    ASSERT_TRUE(soon([&] { return pad() == "Test pad"; })) << pad();
    std::optional<VirtualPad> second(std::in_place, PadLayout::Standard, "Spare pad");
    ASSERT_TRUE(soon([&] { return word().contains("Spare pad is plugged in"); }));
    EXPECT_FALSE(QTest::qWaitFor([&] { return pad() != "Test pad"; }, 1'500)) << pad();
    second.reset();
    ASSERT_TRUE(soon([&] { return word().contains("Spare pad is unplugged"); })) << word().toStdString();
    EXPECT_FALSE(QTest::qWaitFor([&] { return pad() != "Test pad"; }, 1'500)) << "the other one drives";
    m_pad.reset();
    EXPECT_TRUE(soon([&] { return pad().empty(); })) << pad();
}

TEST_F(PadDriveTest, ItsStopStopsAllRobotsAlsoWithoutTheFocusAndAfterwardsEverythingIsLetGoFirst) {
    drive();
    QWidget other;
    other.show();
    other.activateWindow();
    ASSERT_TRUE(soon([&] { return !m_window->isActiveWindow(); }));
    EXPECT_TRUE(soon([&] { return isZero(robot().drive.velocity); })) << "another window has the focus";
    m_pad->press(button::B);
    ASSERT_TRUE(soon([&] { return robot().stop.acknowledged && robot().stop.standing; }));
    EXPECT_TRUE(soon([&] { return robot("crawler").stop.acknowledged; }));
    m_pad->press(button::B, false);
    other.hide();
    m_window->activateWindow();
    ASSERT_TRUE(soon([&] { return m_window->isActiveWindow(); }));
    ASSERT_TRUE(station().release("kurt3d").ok());
    ASSERT_TRUE(soon([&] { return !robot().stop.stopped && !robot().stop.sent; }));
    // Trigger and stick are held as they were.
    EXPECT_FALSE(QTest::qWaitFor([&] { return speed() > 0.02 || m_window->driving(); }, 500));
    letGo();
    drive();
}

TEST_F(PadDriveTest, DrivesAlsoWhileAPaneThatFloatsHasTheKeyboard) {
    m_window->panes().setArranging(true);
    auto* dock = m_window->panes().findChild<QDockWidget*>("map");
    ASSERT_NE(dock, nullptr);
    dock->setFloating(true);
    dock->activateWindow();
    ASSERT_TRUE(soon([&] { return dock->isActiveWindow() && !m_window->isActiveWindow(); }));
    drive();
    EXPECT_TRUE(m_window->driving());
    m_pad->press(button::LeftShoulder);
    EXPECT_TRUE(soon([&] { return m_window->findChild<DriveInput*>()->withoutEyes(); }));
    m_pad->press(button::LeftShoulder, false);
    m_window->activateWindow();
    ASSERT_TRUE(soon([&] { return m_window->isActiveWindow(); }));
    EXPECT_TRUE(m_window->driving()) << "it is one window";
    letGo();
    EXPECT_TRUE(soon([&] { return std::abs(speed()) < 0.02; }));
}

TEST_F(PadDriveTest, AWindowThatGoesWhileThePadDrivesStopsTheRobot) {
    drive();
    m_window.reset();
    EXPECT_TRUE(soon([&] { return std::abs(speed()) < 0.02; }));
}

TEST_F(PadDriveTest, TheNextRobotIsSelectedStandingAndTheLegendIsShown) {
    drive();
    m_pad->press(button::Y);
    ASSERT_TRUE(soon([&] { return m_window->selected() == "crawler"; }));
    m_pad->press(button::Y, false);
    EXPECT_TRUE(soon([&] { return isZero(robot().drive.velocity); }));
    EXPECT_FALSE(m_window->driving()) << "the trigger is held since before";
    auto* legend = m_window->findChild<PadLegend*>();
    ASSERT_FALSE(legend->isVisible());
    m_pad->press(button::Back);
    ASSERT_TRUE(soon([&] { return legend->isVisible(); }));
    lookAt("pad_legend");
    press(Qt::Key_H);
    EXPECT_TRUE(soon([&] { return !legend->isVisible(); }));
    m_window->commands().trigger("pad.controls");
    auto* dialog = m_window->findChild<PadMappingDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_FALSE(dialog->isModal());
}

TEST_F(PadDriveTest, OneButtonFilesAVictimAnotherConfirmsItAndTheCrossFillsInItsForm) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    tap(button::X);
    ASSERT_TRUE(soon([&] { return victim().has_value(); })) << word().toStdString();
    EXPECT_EQ(victim()->robot, "kurt3d");
    EXPECT_EQ(victim()->status, FindSample::Status::Hypothesis);
    tap(button::A);
    ASSERT_TRUE(soon([&] { return victim()->status == FindSample::Status::Confirmed; }))
        << word().toStdString();

    auto* form = m_window->findChild<VictimForm*>("formPane");
    ASSERT_NE(form, nullptr);
    EXPECT_FALSE(form->isVisible()) << "nobody asked for it";
    auto* situation = form->findChild<QComboBox*>("situation");
    ASSERT_TRUE(soon([&] { return situation->isEnabled(); })) << "the form is that of the victim";
    tap(button::Down);
    EXPECT_TRUE(form->isVisible());
    auto* first = qobject_cast<QComboBox*>(QApplication::focusWidget());
    ASSERT_NE(first, nullptr) << "a field has the focus";
    EXPECT_EQ(first->accessibleName().toStdString(), "Form");
    const VictimSign::State before = victim()->form.state;
    tap(button::Right);
    ASSERT_TRUE(soon([&] { return victim()->form.state != before; }));
    tap(button::Down);
    EXPECT_NE(QApplication::focusWidget(), first);
    tap(button::Up);
    EXPECT_EQ(QApplication::focusWidget(), first);
    for (int i = 0; i < 20 && QApplication::focusWidget() != situation; ++i) tap(button::Down);
    ASSERT_EQ(QApplication::focusWidget(), situation);
    tap(button::Right);
    EXPECT_TRUE(soon([&] {
        return !victim()->situation.empty() &&
               victim()->situation == situation->currentData().toString().toStdString();
    }));
    lookAt("pad_form");
}

TEST_F(PadDriveTest, ItTremblesWhileALostRobotIsNotAcknowledged) {
    ASSERT_TRUE(soon([&] { return robot().link.state == LinkState::Connected; }));
    ASSERT_TRUE(soon([&] { return robot("crawler").link.state == LinkState::Connected; }));
    const auto acts = [&] {
        const auto all = station().alarms().view().alarms;
        return std::count_if(all.begin(), all.end(),
                             [](const Alarm& one) { return one.cause.severity == AlarmSeverity::Act; });
    };
    ASSERT_EQ(acts(), 0);
    const int before = m_pad->rumbles();
    m_robots.reset();
    ASSERT_TRUE(soon([&] { return acts() == 2; })) << "both are lost";
    // Again and again, until somebody acknowledges.
    EXPECT_TRUE(soon([&] { return m_pad->rumbles() >= before + 2; })) << m_pad->rumbles() - before;
    for (int i = 0; i < 20 && station().alarms().view().loud; ++i) press(Qt::Key_Backspace);
    ASSERT_FALSE(station().alarms().view().loud);
    QTest::qWait(500);  // what was on its way
    const int after = m_pad->rumbles();
    EXPECT_FALSE(QTest::qWaitFor([&] { return m_pad->rumbles() > after; }, 5'000));
}

TEST_F(PadDriveTest, ItsRightStickTurnsTheLargeCameraWithoutTheTrigger) {
    const auto angles = [&] {
        const auto turn = station().cameras().turning().view("kurt3d", "left");
        return turn && turn->now ? *turn->now : PanTiltAngles{NAN, NAN};
    };
    ASSERT_TRUE(soon([&] { return std::abs(angles().pan) < 0.05 && std::abs(angles().tilt) < 0.05; }));
    m_pad->push(axis::RightX, -1.0);
    EXPECT_TRUE(soon([&] { return angles().pan > 0.3; })) << "to the left, while it is held";
    m_pad->push(axis::RightX, 0.0);
    EXPECT_LT(std::abs(angles().tilt), 0.05);
    // Let go, it stays as it is.
    double pan = NAN;
    ASSERT_TRUE(soon([&] {
        const double was = std::exchange(pan, angles().pan);
        QTest::qWait(300);
        return std::abs(angles().pan - was) < 0.01;
    }));
    EXPECT_GT(angles().pan, 0.3);
    m_pad->push(axis::RightY, -1.0);
    EXPECT_TRUE(soon([&] { return angles().tilt < -0.2; })) << "upwards";
    m_pad->push(axis::RightY, 0.0);
    EXPECT_FALSE(m_window->driving()) << "a look around drives nothing";
    EXPECT_LT(std::abs(speed()), 0.02);
}

TEST_F(PadDriveTest, ALayoutBindsItsButtons) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    const QString selected = m_window->selected();
    ASSERT_TRUE(m_window->layouts().saveAs("With a pad"));
    const auto file = std::filesystem::path(m_folder.path().toStdString()) / "layouts" / "with-a-pad.yaml";
    {
        std::ofstream out(file, std::ios::app);
        out << "pad: {y: camera.recentre}\n";
        ASSERT_TRUE(out.good()) << file;
    }
    ASSERT_TRUE(m_window->layouts().use("drive"));
    ASSERT_TRUE(m_window->layouts().use("with-a-pad")) << word().toStdString();
    const auto pan = [&] {
        const auto turn = station().cameras().turning().view("kurt3d", "left");
        return turn && turn->now ? turn->now->pan : NAN;
    };
    ASSERT_TRUE(soon([&] { return std::abs(pan()) < 0.05; }));
    m_pad->push(axis::RightX, -1.0);
    ASSERT_TRUE(soon([&] { return pan() > 0.3; }));
    m_pad->push(axis::RightX, 0.0);
    tap(button::Y);
    EXPECT_TRUE(soon([&] { return std::abs(pan()) < 0.05; })) << "as the layout says";
    EXPECT_EQ(m_window->selected(), selected) << "and not what Y does in others";
}

}  // namespace
}  // namespace leitstand::test
