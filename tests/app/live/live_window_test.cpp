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
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/points/map_colours.h"
#include "widgets/painting/theme.h"
#include "widgets/robots/release_handle.h"

namespace leitstand::test {
namespace {

/// A robot goes after its button was held for a second.
constexpr int TooShort = 500, LongEnough = 1'300;  ///< [ms]

class LiveWindowTest : public LivePage {
protected:
    [[nodiscard]] ReleaseHandle* handle(const char* title = "Kurt3D") const {
        for (ReleaseHandle* one : m_window->findChildren<ReleaseHandle*>()) {
            if (one->accessibleName() == QStringLiteral("Release %1").arg(QLatin1String(title))) return one;
        }
        return nullptr;
    }
    /// Takes the sticks and holds W until the robot drives.
    void driveAhead() {
        ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
        press(Qt::Key_F2);
        ASSERT_TRUE(m_window->driving());
        ASSERT_TRUE(soon([&] { return mayDrive(); }));
        QTest::qWait(300);  // the operator's hand is not faster
        QTest::keyPress(m_window.get(), Qt::Key_W);
        ASSERT_TRUE(soon([&] { return speed() > 0.1; }));
    }
    /// Holds the pointer down on the lower half of its button.
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
    ASSERT_NO_FATAL_FAILURE(driveAhead());
    press(Qt::Key_Escape);
    ASSERT_TRUE(soon([&] { return robot().stop.acknowledged && robot().stop.standing; }));
    EXPECT_TRUE(soon([&] { return robot("crawler").stop.acknowledged; })) << "Esc stops all";
    QTest::keyRelease(m_window.get(), Qt::Key_W);
    EXPECT_LT(std::abs(speed()), 0.02);
    hold(LongEnough);
    EXPECT_TRUE(soon([&] { return !robot().stop.stopped; }));
}

TEST_F(LiveWindowTest, SpaceHaltsTheRobotThatIsDrivenAndTheOneThatDrivesByItself) {
    ASSERT_NO_FATAL_FAILURE(driveAhead());
    press(Qt::Key_Space);
    EXPECT_TRUE(soon([&] { return std::abs(speed()) < 0.02; }));
    EXPECT_FALSE(QTest::qWaitFor([&] { return std::abs(speed()) > 0.02; }, 1'000)) << "W is still down";
    EXPECT_FALSE(robot().stop.stopped) << "it stands, and needs no release";
    QTest::keyRelease(m_window.get(), Qt::Key_W);

    const auto mode = [&] {
        const auto reported = station().mission()->robots.at("kurt3d")->mode;
        return reported ? reported->sample.mode : std::string();
    };
    ASSERT_TRUE(soon([&] {
        (void)station().setMode("kurt3d", "explore");
        return mode() == "explore" && std::abs(speed()) > 0.02;
    }));
    ASSERT_TRUE(m_window->driving());
    press(Qt::Key_Space);
    EXPECT_TRUE(soon([&] { return mode() == "teleoperation" && std::abs(speed()) < 0.02; })) << mode();
    EXPECT_FALSE(robot().stop.stopped);
}

TEST_F(LiveWindowTest, AKeyThatIsHeldDrivesNobodyOnceAnotherWindowHasTheKeyboard) {
    ASSERT_NO_FATAL_FAILURE(driveAhead());
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

TEST_F(LiveWindowTest, AMessageStaysOnItsLineWhateverOthersSayInIt) {
    m_window->showMessage(QString::fromUtf8("rover: \u202ewrong\nhot"));
    EXPECT_EQ(m_window->newest().toStdString(), "rover: \\u202ewrong · hot");
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
    ASSERT_TRUE(soon([&] { return station().mission()->robots.at("kurt3d")->mode != nullptr; }));
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

/// What of @p picture has colours as walls have in the map, from 0 to 1.
double wallsOf(const QImage& picture) {
    const Rgba wall = labelColour(Label::Wall);
    return static_cast<double>(countOf(picture, QColor(wall.r, wall.g, wall.b), 12)) /
           (picture.width() * picture.height());
}

/// How many greys a picture has that is no plain area.
std::size_t greysOf(const QImage& picture) {
    std::set<int> greys;
    for (int y = 0; y < picture.height(); y += 2) {
        for (int x = 0; x < picture.width(); x += 2) greys.insert(qGray(picture.pixel(x, y)));
    }
    return greys.size();
}

struct Screen {
    const char* layout;
    int width, height;
    const char* scale;
};

std::ostream& operator<<(std::ostream& out, const Screen& screen) {
    return out << screen.layout << " " << screen.width << " x " << screen.height;
}

class LiveScreenshots : public testing::TestWithParam<Screen> {};

TEST_P(LiveScreenshots, ShowMapAndCameraOfTheDemo) {
    const Screen& screen = GetParam();
    const TestDomain domain;
    const QTemporaryDir folder;
    const QString file = folder.filePath("live.png");
    ChildProcess program(
        test::program("leitstand"),
        {"--demo", "--domain", std::to_string(domain.number()), "--layout", screen.layout, "--screenshot",
         file.toStdString(), "--size", std::to_string(screen.width) + "x" + std::to_string(screen.height)},
        {std::string("QT_SCALE_FACTOR=") + screen.scale});
    EXPECT_EQ(program.wait(), 0) << program.out();
    const QImage picture(file);
    ASSERT_EQ(picture.size(), QSize(screen.width, screen.height));
    const auto part = [&](double left, double top, double right, double bottom) {
        const int w = screen.width, h = screen.height;
        return picture.copy(static_cast<int>(left * w), static_cast<int>(top * h),
                            static_cast<int>((right - left) * w), static_cast<int>((bottom - top) * h));
    };
    const bool drive = std::string(screen.layout) == "drive";
    EXPECT_GT(wallsOf(drive ? part(0.63, 0.16, 0.99, 0.44) : part(0.02, 0.16, 0.65, 0.75)), 0.003)
        << "the map's walls";
    EXPECT_GT(greysOf(drive ? part(0.05, 0.2, 0.55, 0.7) : part(0.67, 0.54, 0.82, 0.7)), 40U)
        << "the camera's picture";
}

INSTANTIATE_TEST_SUITE_P(Layouts, LiveScreenshots,
                         testing::Values(Screen{"drive", 1280, 800, "1"}, Screen{"explore", 1280, 800, "1"},
                                         Screen{"drive", 3840, 2160, "2"},
                                         Screen{"explore", 3840, 2160, "2"}),
                         [](const auto& one) {
                             return std::string(one.param.layout) + std::to_string(one.param.width);
                         });

}  // namespace
}  // namespace leitstand::test
