#include "tests/app/live/live_page.h"

#include <cmath>

#include <QAction>
#include <QMenu>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mission/mission_state.h"
#include "tests/support/child_process.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

using LiveWindowTest = LivePage;

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
    ASSERT_TRUE(station().release("kurt3d").ok());
    EXPECT_TRUE(soon([&] { return !robot().stop.stopped; }));
}

TEST_F(LiveWindowTest, AScanIsRegisteredDrawnAndInTheLog) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    EXPECT_TRUE(soon([&] { return !station().mission()->keyScans->empty(); }));
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
    ASSERT_TRUE(soon([&] { return station().mission()->robots.contains("kurt3d"); }));
    ASSERT_TRUE(soon([&] { return station().mission()->robots.at("kurt3d")->mode.has_value(); }));
    QMenu* modes = nullptr;
    for (QMenu* menu : m_window->findChildren<QMenu*>()) {
        if (menu->title() == "&Mode") modes = menu;
    }
    ASSERT_NE(modes, nullptr);
    QStringList texts;
    EXPECT_TRUE(soon([&] {
        emit modes->aboutToShow();
        texts.clear();
        for (const QAction* action : modes->actions()) texts += action->text();
        return texts.contains("explore");
    })) << texts.join(", ").toStdString();
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
