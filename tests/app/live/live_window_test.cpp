#include "tests/app/live/live_page.h"

#include <cmath>
#include <set>

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QTest>
#include <QToolButton>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/commands/command_table.h"
#include "core/mission/mission_state.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/drive/release_handle.h"
#include "widgets/map_view/map_view.h"
#include "widgets/theme.h"

namespace leitstand::test {
namespace {

/// A robot goes after its handle was held for a second.
constexpr int TooShort = 500, LongEnough = 1'300;  ///< [ms]

class LiveWindowTest : public LivePage {
protected:
    [[nodiscard]] ReleaseHandle* handle(const char* title = "Kurt3D") const {
        for (ReleaseHandle* one : m_window->findChildren<ReleaseHandle*>()) {
            if (one->accessibleName() == QStringLiteral("Release %1").arg(QLatin1String(title))) return one;
        }
        return nullptr;
    }
    /// Holds the pointer down on the handle beside STOP.
    void hold(int milliseconds) {
        ReleaseHandle* const beside = handle();
        ASSERT_NE(beside, nullptr);
        // It takes no hold before the robot stands.
        ASSERT_TRUE(soon([&] { return beside->isVisible() && beside->focusPolicy() == Qt::TabFocus; }));
        QTest::mousePress(beside, Qt::LeftButton);
        ASSERT_TRUE(beside->isHeld());
        QTest::qWait(milliseconds);
        QTest::mouseRelease(beside, Qt::LeftButton);
    }
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
    hold(LongEnough);
    EXPECT_TRUE(soon([&] { return !robot().stop.stopped; }));
}

TEST_F(LiveWindowTest, AKeyThatIsHeldDrivesNobodyOnceAnotherWindowHasTheKeyboard) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    press(Qt::Key_F2);
    ASSERT_TRUE(
        soon([&] { return robot().grant.mine && robot().drive.listening && !robot().drive.needsNeutral; }));
    QTest::qWait(300);  // the operator's hand is not faster
    QTest::keyPress(m_window.get(), Qt::Key_W);
    ASSERT_TRUE(soon([&] { return speed() > 0.1; }));
    QWidget other;
    other.show();
    other.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&other));
    ASSERT_TRUE(soon([&] { return !m_window->driving() && std::abs(speed()) < 0.02; }));
    EXPECT_FALSE(robot().stop.stopped) << "it stands, and needs no release";
    m_window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
    EXPECT_FALSE(QTest::qWaitFor([&] { return std::abs(speed()) > 0.02; }, 1'000))
        << "the key that is still down does not drive on by itself";
    QTest::keyRelease(m_window.get(), Qt::Key_W);
}

TEST_F(LiveWindowTest, TheStopButtonStopsAllAndAHandleHeldForASecondReleasesItsRobotAlone) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    m_window->findChild<QToolButton*>(QStringLiteral("grant"))->click();
    ASSERT_TRUE(soon([&] { return robot().grant.mine; })) << "who releases it has to have the grant";
    auto* const stop = m_window->findChild<QAbstractButton*>(QStringLiteral("stop"));
    ASSERT_NE(stop, nullptr);
    QTest::mouseClick(stop, Qt::LeftButton);
    ASSERT_TRUE(soon([&] {
        return robot().stop.stopped && robot().stop.standing && robot("crawler").stop.stopped &&
               robot("crawler").stop.standing;
    }));
    hold(TooShort);
    EXPECT_FALSE(QTest::qWaitFor([&] { return !robot().stop.stopped || robot().stop.releasing; }, 1'500))
        << "let go too early";
    hold(LongEnough);
    EXPECT_TRUE(soon([&] { return !robot().stop.stopped; }));
    EXPECT_TRUE(soon([&] { return !handle()->isVisible(); }));
    EXPECT_TRUE(robot("crawler").stop.stopped) << "each robot is released by itself";
    EXPECT_TRUE(handle("Crawler")->isVisible());
}

TEST_F(LiveWindowTest, AnotherThemeIsWornAtOnceByAllPanesThatWereThere) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    const auto shown = [&] {
        QStringList names;
        for (const QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            if (dock->isVisible()) names += dock->objectName();
        }
        names.sort();
        return names.join(QLatin1Char(' ')).toStdString();
    };
    const std::string before = shown();
    ASSERT_THAT(before, testing::HasSubstr("map"));
    auto* const strip = m_window->findChild<DriveStrip*>();
    ASSERT_NE(strip, nullptr);
    const auto lightness = [&] {
        const QImage painted = strip->grab().toImage();
        return painted.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
            .pixelColor(0, 0)
            .lightness();
    };
    const bool dark = presentTheme() == Theme::Dark;
    const auto wear = [&](bool light) {
        QAction* const theme = m_window->commands().find(light ? "themeLight" : "themeDark");
        ASSERT_NE(theme, nullptr);
        theme->trigger();
        EXPECT_EQ(presentTheme(), light ? Theme::Light : Theme::Dark);
        EXPECT_EQ(m_window->view().theme, presentTheme()) << "as it is remembered";
        EXPECT_EQ(m_window->mapView().settings().theme, presentTheme());
        EXPECT_TRUE(soon([&] { return (lightness() > 128) == light; })) << lightness();
        EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
        EXPECT_EQ(shown(), before);
    };
    wear(dark);
    lookAt("other_theme");
    wear(!dark);
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
    ChildProcess program(test::program("leitstand"),
                         {"--demo", "--domain", std::to_string(domain.number()), "--screenshot",
                          file.toStdString(), "--size", "1280x800"});
    EXPECT_EQ(program.wait(), 0) << program.out();
    const QImage picture(file);
    EXPECT_EQ(picture.size(), QSize(1280, 800));
}

TEST(LiveScreenshot, ShowsTheDemosRobotsExploringAWhileLater) {
    const TestDomain domain;
    const QTemporaryDir folder;
    const QString file = folder.filePath("live.png");
    ChildProcess program(test::program("leitstand"),
                         {"--demo", "--domain", std::to_string(domain.number()), "--after", "15",
                          "--screenshot", file.toStdString(), "--size", "1280x800"});
    EXPECT_EQ(program.wait(), 0) << program.out();
    const QImage strip = QImage(file).copy(0, 560, 400, 240);
    EXPECT_GT(countOf(strip, coloursOf(Theme::Dark).autonomous, 4), 8'000) << "the mode's background";
}

TEST(LiveScreenshot, ShowsAnotherLayoutAtTwiceTheScaleInAsManyPixelsAsAskedFor) {
    const TestDomain domain;
    const QTemporaryDir folder;
    const QString file = folder.filePath("live.png");
    ChildProcess program(test::program("leitstand"),
                         {"--demo", "--domain", std::to_string(domain.number()), "--layout", "explore",
                          "--screenshot", file.toStdString(), "--size", "3840x2160"},
                         {"QT_SCALE_FACTOR=2"});
    EXPECT_EQ(program.wait(), 0) << program.out();
    const QImage picture(file);
    ASSERT_EQ(picture.size(), QSize(3840, 2160));
    // The map is large: in its left half there is something of it.
    std::set<QRgb> colours;
    for (int y = 400; y < 1500; ++y) {
        for (int x = 300; x < 1900; ++x) colours.insert(picture.pixel(x, y));
    }
    EXPECT_GT(colours.size(), 3U);
}

}  // namespace
}  // namespace leitstand::test
