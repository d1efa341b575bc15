#include "tests/app/live/quiet_page.h"

#include <algorithm>
#include <set>

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/services/finds/find_desk.h"
#include "app/services/station/safety/station_alarms.h"
#include "app/window/frame/pane_docks.h"
#include "core/mission/state/mission_state.h"
#include "widgets/victims/victim_form.h"

namespace leitstand::test {
namespace {

class CommandsEnabled : public QuietPage {
protected:
    [[nodiscard]] bool can(const char* id) const { return command(id).isEnabled(); }
};

TEST_F(CommandsEnabled, AsTheSelectedRobotsCamerasAllow) {
    const std::vector<const char*> ofKurt3D = {"camera.recentre", "camera.left",          "camera.right",
                                               "camera.up",       "camera.down",          "camera.next",
                                               "camera.exchange", "camera.snapshotSmall", "ir.iron",
                                               "ir.greyHot",      "ir.greyCold",          "ir.autoRange"};
    for (const char* id : ofKurt3D) EXPECT_TRUE(can(id)) << id;
    EXPECT_FALSE(can("omni.unwarp")) << "no camera of Kurt3D sees all around";
    command("robot.2").trigger();
    ASSERT_EQ(window().selected(), "crawler");
    for (const char* id : ofKurt3D) EXPECT_FALSE(can(id)) << id;
    EXPECT_TRUE(can("camera.snapshot"));
    command("robot.1").trigger();
    for (const char* id : ofKurt3D) EXPECT_TRUE(can(id)) << id;
}

/// Kurt3D with an infrared camera that sends colours instead of temperatures.
class ColouredInfrared : public testing::Test {
protected:
    ColouredInfrared()
        : m_live(openLiveStation(m_folder.path().toStdString(), m_domain.number(), {robot()})) {}
    static RobotDescription robot() {
        RobotDescription kurt = shippedRobot("kurt3d");
        for (StreamDescription& stream : kurt.streams) stream.thermal.measured = false;
        return kurt;
    }

    const TestDomain m_domain;
    const QTemporaryDir m_folder;
    const LiveStation m_live;
};

TEST_F(ColouredInfrared, HasNoPaletteToChoose) {
    for (const char* id : {"ir.iron", "ir.greyHot", "ir.greyCold", "ir.autoRange"}) {
        const QAction* const one = m_live.window->commands().find(QLatin1String(id));
        ASSERT_NE(one, nullptr) << id;
        EXPECT_FALSE(one->isEnabled()) << id;
    }
    EXPECT_TRUE(m_live.window->commands().find(QStringLiteral("camera.next"))->isEnabled());
}

TEST_F(CommandsEnabled, TurningFollowsTheLargeCamera) {
    EXPECT_TRUE(can("camera.left"));
    command("camera.exchange").trigger();
    EXPECT_TRUE(can("camera.left")) << "the infrared camera is on the other pan-tilt unit";
}

TEST_F(CommandsEnabled, AcknowledgeWhileAnAlarmWaits) {
    const auto waits = [&] {
        const auto alarms = station().alarms().view().alarms;
        return std::any_of(alarms.begin(), alarms.end(), [](const Alarm& one) { return !one.acknowledged; });
    };
    EXPECT_TRUE(soon([&] { return can("alarm.acknowledge") == waits(); }));
    station().stopAll();  // which nobody answers
    ASSERT_TRUE(soon([&] { return waits() && can("alarm.acknowledge"); }));
    EXPECT_TRUE(soon([&] {
        if (waits()) press(Qt::Key_Backspace);
        return !can("alarm.acknowledge") && !waits();
    }));
}

TEST_F(CommandsEnabled, TheFormsCommandsOpenTheForm) {
    command("form.next").trigger();
    EXPECT_TRUE(window().newest().contains(QStringLiteral("Choose a filed find"))) << "none is chosen";
    EXPECT_FALSE(window().panes().isPaneVisible(QStringLiteral("form")));
    station().finds().freezeAt("kurt3d", FindSample::Kind::Victim, {1.0, 0.0, 0.2});
    auto* const finds = window().findChild<QTableView*>(QStringLiteral("finds"));
    ASSERT_NE(finds, nullptr);
    ASSERT_TRUE(soon([&] { return finds->model()->rowCount() == 1 && finds->currentIndex().isValid(); }));
    command("form.change").trigger();
    EXPECT_TRUE(window().panes().isPaneVisible(QStringLiteral("form")));
    const auto* const form = window().findChild<VictimForm*>(QStringLiteral("formPane"));
    ASSERT_NE(form, nullptr);
    EXPECT_TRUE(soon([&] {
        return QApplication::focusWidget() != nullptr && form->isAncestorOf(QApplication::focusWidget());
    }));
}

TEST_F(CommandsEnabled, NoMnemonicStandsTwiceInTheMenuCameras) {
    std::set<QChar> seen;
    for (const QAction* one : window().commands().menu(CommandMenu::Cameras).actions()) {
        const QString text = one->text();
        const auto at = text.indexOf(QLatin1Char('&'));
        if (at < 0 || at + 1 >= text.size()) continue;
        EXPECT_TRUE(seen.insert(text.at(at + 1).toLower()).second) << text.toStdString();
    }
    EXPECT_GT(seen.size(), 10U);
}

}  // namespace
}  // namespace leitstand::test
