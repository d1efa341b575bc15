#include "app/window/live/live_window.h"

#include <cmath>

#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/live/demo_robots.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/mission_state.h"
#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

constexpr int Patience = 60'000;  ///< of real robots on a busy machine [ms]

/// The live window on both simulated robots.
class LiveWindowTest : public testing::Test {
protected:
    LiveWindowTest() {
        StationSettings settings;
        const std::filesystem::path folder = m_folder.path().toStdString();
        settings.domain.domain = m_domain.number();
        settings.mission.folder = folder / "mission";
        settings.memory = folder / "station.yaml";
        for (const char* name : {"kurt3d", "crawler"}) {
            settings.mission.robots.push_back(
                readRobot(std::string(LEITSTAND_SOURCE_DIR) + "/resources/robots/" + name + ".yaml").value());
        }
        m_bridge = LiveBridge::open(settings).value();
        m_window = std::make_unique<LiveWindow>(*m_bridge, MapViewSettings{});
        DemoSettings demo;
        demo.program = QStringLiteral(LEITSTAND_ROBOT);
        demo.domain = m_domain.number();
        m_robots = std::make_unique<DemoRobots>(demo);
        m_robots->start();
        m_window->resize(1280, 800);
        m_window->show();
        m_window->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
    }
    template <class Holds>
    [[nodiscard]] static bool soon(Holds holds) {
        return QTest::qWaitFor(holds, Patience);
    }
    [[nodiscard]] RobotView robot(const char* name = "kurt3d") const {
        return m_bridge->station().robot(name);
    }
    /// As its odometry tells [m/s].
    [[nodiscard]] double speed(const char* name = "kurt3d") const {
        const auto mission = m_bridge->station().mission();
        const auto said = mission->robots.find(name);
        if (said == mission->robots.end() || !said->second->odometry) return 0.0;
        return said->second->odometry->sample.linear.x();
    }
    /// For people: a picture of the window in the folder LEITSTAND_PICTURES.
    void lookAt(const QString& name) {
        const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
        if (folder.isEmpty()) return;
        EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
        m_window->grab().save(folder + "/live_" + name + ".png");
    }
    void press(Qt::Key key) { QTest::keyClick(m_window.get(), key); }

    const TestDomain m_domain;
    const QTemporaryDir m_folder;
    std::unique_ptr<LiveBridge> m_bridge;
    std::unique_ptr<LiveWindow> m_window;
    std::unique_ptr<DemoRobots> m_robots;
};

TEST_F(LiveWindowTest, DrivesWithKeysStopsWithEscAndReleases) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    press(Qt::Key_F2);
    ASSERT_TRUE(m_window->driving());
    ASSERT_TRUE(
        soon([&] { return robot().grant.mine && robot().drive.listening && !robot().drive.needsNeutral; }));
    QTest::qWait(300);  // the operator's hand is not faster
    QTest::keyPress(m_window.get(), Qt::Key_W);
    ASSERT_TRUE(soon([&] { return speed() > 0.1; }));
    press(Qt::Key_Escape);
    ASSERT_TRUE(soon([&] { return robot().stop.acknowledged && robot().stop.standing; }));
    EXPECT_TRUE(soon([&] { return robot("crawler").stop.acknowledged; })) << "Esc stops all";
    QTest::keyRelease(m_window.get(), Qt::Key_W);
    EXPECT_LT(std::abs(speed()), 0.02);
    ASSERT_TRUE(m_bridge->station().release("kurt3d").ok());
    EXPECT_TRUE(soon([&] { return !robot().stop.stopped; }));
}

TEST_F(LiveWindowTest, AScanIsRegisteredDrawnAndInTheLog) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    EXPECT_TRUE(soon([&] { return !m_bridge->station().mission()->keyScans->empty(); }));
}

TEST_F(LiveWindowTest, AnotherRobotIsSelectedByItsNumberAndEndsDriving) {
    ASSERT_TRUE(soon([&] { return robot("crawler").link.state == LinkState::Connected; }));
    press(Qt::Key_F2);
    ASSERT_TRUE(m_window->driving());
    press(Qt::Key_2);
    EXPECT_TRUE(soon([&] { return m_window->selected() == "crawler"; }));
    EXPECT_FALSE(m_window->driving());
    press(Qt::Key_1);
    EXPECT_TRUE(soon([&] { return m_window->selected() == "kurt3d"; }));
}

TEST_F(LiveWindowTest, CameraAndMapChangePlaces) {
    QWidget* const camera = m_window->findChild<QWidget*>("cameraPane");
    const int before = camera->width() * camera->height();
    press(Qt::Key_X);
    EXPECT_TRUE(soon([&] { return camera->width() * camera->height() < before / 2; }));
    lookAt("swapped");
    press(Qt::Key_X);
    EXPECT_TRUE(soon([&] { return camera->width() * camera->height() > before / 2; }));
}

TEST_F(LiveWindowTest, ModesThatTheRobotOffersAreInTheMenu) {
    ASSERT_TRUE(soon([&] { return m_bridge->station().mission()->robots.contains("kurt3d"); }));
    ASSERT_TRUE(soon([&] { return m_bridge->station().mission()->robots.at("kurt3d")->mode.has_value(); }));
    QMenu* modes = nullptr;
    for (QMenu* menu : m_window->findChildren<QMenu*>()) {
        if (menu->title() == "&Mode") modes = menu;
    }
    ASSERT_NE(modes, nullptr);
    emit modes->aboutToShow();
    QStringList texts;
    for (const QAction* action : modes->actions()) texts += action->text();
    EXPECT_TRUE(texts.contains("explore")) << texts.join(", ").toStdString();
}

TEST(LiveScreenshot, ShowsTheDemo) {
    const TestDomain domain;
    const QTemporaryDir folder;
    const QString file = folder.filePath("live.png");
    ChildProcess program(LEITSTAND, {"--demo", "--domain", std::to_string(domain.number()), "--screenshot",
                                     file.toStdString(), "--size", "1280x800"});
    EXPECT_EQ(program.wait(), 0) << program.out();
    const QImage picture(file);
    EXPECT_EQ(picture.size(), QSize(1280, 800));
}

}  // namespace
}  // namespace leitstand::test
