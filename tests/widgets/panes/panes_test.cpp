#include <chrono>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAbstractButton>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/core/perception/virtual_world.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/drive/mode_cell.h"
#include "widgets/drive/stop_button.h"
#include "widgets/robots/release_handle.h"
#include "widgets/robots/robot_bar.h"
#include "widgets/robots/robot_chip_button.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

std::vector<std::string> wordsOf(QWidget& widget) {
    std::vector<std::string> words;
    for (const PaintedText& one : paintedTexts(widget)) words.push_back(one.text.toStdString());
    return words;
}

QImage plain(const QColor& colour) {
    QImage image(320, 240, QImage::Format_RGB32);
    image.fill(colour);
    return image;
}

class Panes : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
    [[nodiscard]] const ThemeColours& colours() const { return coloursOf(GetParam()); }

    SampleRobot robot = sampleRobot();
};

TEST_P(Panes, ACameraIsColouredThenGreyThenHardlySeen) {
    CameraPane pane;
    pane.setCamera(robot.face, QStringLiteral("Left camera"));
    pane.setPicture(plain(QColor(200, 60, 20)));
    const QRect inner(60, 100, 200, 60);
    pane.setAge({.arrival = 0.064, .content = 0.064}, QStringLiteral("full speed"));
    EXPECT_EQ(countOf(pictureOf(pane, {320, 280}, {}).copy(inner), QColor(200, 60, 20)), 200 * 60);
    EXPECT_THAT(wordsOf(pane), Contains("64 ms · full speed"));
    EXPECT_THAT(wordsOf(pane), Contains("K · Left camera"));
    pane.setAge({.arrival = 0.1, .content = 1.4});
    EXPECT_EQ(colouredPixels(pictureOf(pane, {320, 280}, {}).copy(inner)), 0);
    EXPECT_THAT(wordsOf(pane), Contains("same for 1.4 s"));
    pane.setAge({.arrival = 4.4, .content = 4.4});
    const QImage lost = pictureOf(pane, {320, 280}, {});
    EXPECT_THAT(wordsOf(pane), Contains("no data for 4 s"));
    EXPECT_GT(countOf(lost, colours().attention, 40), 100);
    // what is behind the words is nearly the empty pane
    EXPECT_LT(qAbs(qGray(lost.pixel(60, 220)) - qGray(coloursOf(Theme::Dark).pane.rgb())), 30);
    pane.setCamera({"c", "C", "Crawler", 1}, QStringLiteral("Omni"));
    (void)pictureOf(pane, {320, 280}, {});
    EXPECT_THAT(wordsOf(pane), Contains("no data yet")) << "another camera does not show this one's picture";
    EXPECT_TRUE(pane.pictureArea().isEmpty());
}

TEST_P(Panes, TheRingIsAmberOnlyWhereSomethingIsNear) {
    CameraPane pane;
    pane.setCamera(robot.face, QStringLiteral("Left camera"));
    pane.setPicture(plain(Qt::black));
    pane.setAge({.arrival = 0.0, .content = 0.0});
    const auto amber = [&](double gap, double speed) {
        CameraOverlay overlay;
        overlay.ring = proximityRing(corridor(gap), boxAround(robot.description.footprint), {speed, 0, 0});
        pane.setOverlay(overlay);
        return countOf(pictureOf(pane, {640, 480}, {}), coloursOf(Theme::Dark).attention, 20);
    };
    EXPECT_EQ(amber(0.9, 0.0), 0);
    EXPECT_GT(amber(0.6, 0.4), 200);
    EXPECT_THAT(wordsOf(pane), Contains(HasSubstr("0.6")));
}

TEST_P(Panes, AClickTellsWhereInThePictureItWas) {
    CameraPane pane;
    pane.setPicture(plain(Qt::gray));
    pane.resize(640, 600);
    QSignalSpy clicked(&pane, &CameraPane::pictureClicked);
    QTest::mouseClick(&pane, Qt::LeftButton, {}, {160, 300});
    ASSERT_EQ(clicked.size(), 1);
    EXPECT_NEAR(clicked[0][0].toDouble(), 0.25, 0.01);
    EXPECT_NEAR(clicked[0][1].toDouble(), 0.5, 0.01);
    QTest::mouseClick(&pane, Qt::LeftButton, {}, {160, 30});
    EXPECT_EQ(clicked.size(), 1) << "above the picture";
}

TEST_P(Panes, TheVirtualScanShowsWallsObstaclesAndItsAge) {
    VirtualScanPane pane;
    pane.setRobot(robot.face, robot.description.footprint);
    pane.show(robot.view.around, robot.view.drive.velocity, 0.1);
    const QImage live = pictureOf(pane, {400, 400}, {});
    EXPECT_GT(countOf(live, colours().wall, 30), 100);
    EXPECT_GT(countOf(live, colours().select, 30), 20) << "the predicted path";
    const QPoint box = pane.pixelOf({1.125, -0.4}).toPoint();
    EXPECT_GT(countOf(live.copy(QRect(box - QPoint(8, 8), QSize(17, 17))), colours().obstacle, 30), 8);
    EXPECT_THAT(wordsOf(pane), Contains("0.91 m"));
    EXPECT_THAT(wordsOf(pane), Contains("100 ms"));
    pane.show(robot.view.around, robot.view.drive.velocity, 1.6);
    const QImage stale = pictureOf(pane, {400, 400}, {});
    EXPECT_LT(colouredPixels(stale.copy(10, 60, 380, 330), 40), 4);
    pane.show(robot.view.around, {}, 4.2);
    (void)pictureOf(pane, {400, 400}, {});
    EXPECT_THAT(wordsOf(pane), Contains("no data for 4 s"));
    pane.show(std::nullopt, {}, INFINITY);
    (void)pictureOf(pane, {400, 400}, {});
    EXPECT_THAT(wordsOf(pane), Contains("no data yet"));
}

TEST_P(Panes, WhatALaserMeasuredIsALayerOfItsOwn) {
    VirtualScanPane pane;
    pane.setRobot(robot.face, robot.description.footprint);
    VirtualScanView view = *robot.view.around;
    for (int i = 0; i < 80; ++i) view.laser.emplace_back(1.8F, -0.8F + 0.02F * static_cast<float>(i));
    view.laserAge = 0.1;
    pane.show(view, {}, 0.1);
    const auto dots = [&] { return countOf(pictureOf(pane, {400, 400}, {}), colours().laser, 30); };
    EXPECT_GT(dots(), 100);
    pane.setLaserShown(false);
    EXPECT_EQ(dots(), 0);
}

TEST_P(Panes, WallsAreNoObstaclesOfTheirOwnAsAScannerSeesThem) {
    VirtualWorld world;
    world.blocks = {{{6, -1, 0}, {6.1, 1, 2}},      {{-2.1, -1, 0}, {-2, 1, 2}},
                    {{-2, 0.8, 0}, {1.5, 0.9, 2}},  {{2.5, 0.8, 0}, {6, 0.9, 2}},
                    {{1.5, 2.5, 0}, {2.5, 2.6, 2}}, {{-2, -0.9, 0}, {6, -0.8, 2}}};
    const auto look = [&](const QString& name) {
        VirtualScanSettings settings;
        settings.body = boxAround(robot.description.footprint);
        VirtualScan scanned(settings);
        scan(world, scanned, standing(), 0.0, 2.4);
        VirtualScanPane pane;
        pane.setRobot(robot.face, robot.description.footprint);
        pane.show(scanned.view(Pose::Identity(), atSecond(2.4)), {0.3, 0.0, 0.0}, 0.1);
        // the lower left has walls, but neither figures nor the robot
        const QImage picture = pictureOf(pane, {480, 480}, name);
        const QPoint box = pane.pixelOf({1.7, 0.15}).toPoint();
        return std::pair(
            countOf(picture.copy(0, 345, 200, 135), colours().obstacle, 30),
            countOf(picture.copy(QRect(box - QPoint(20, 20), QSize(41, 41))), colours().obstacle, 30));
    };
    EXPECT_LT(look(QStringLiteral("scan-walls")).first, 10);
    world.blocks.push_back({{1.7, -0.1, 0}, {2.0, 0.3, 0.4}});
    const auto [walls, box] = look(QStringLiteral("scan-box"));
    EXPECT_LT(walls, 10);
    EXPECT_GT(box, 30);
}

TEST_P(Panes, WhatWasLookedAtLongAgoIsFainter) {
    VirtualScanPane pane;
    pane.setRobot(robot.face, robot.description.footprint);
    const auto wallPixels = [&](double age) {
        VirtualScanView view = corridor();
        view.at += std::chrono::seconds(static_cast<int>(age));
        for (VirtualSector& sector : view.sectors) sector.age = age;
        view.obstacles.clear();
        pane.show(view, {}, 0.1);
        return countOf(pictureOf(pane, {400, 400}, {}), colours().wall, 25);
    };
    EXPECT_GT(wallPixels(0.5), 200);
    EXPECT_LT(wallPixels(9.0), 20);
}

TEST_P(Panes, EachSectorHasAnAgeOfItsOwn) {
    VirtualScanPane pane;
    pane.setRobot(robot.face, robot.description.footprint);
    VirtualScanView view = corridor();
    view.at += std::chrono::seconds(9);
    for (int i = 0; i < static_cast<int>(view.sectors.size()); ++i)
        view.sectors[static_cast<std::size_t>(i)].age = view.directionOf(i) > 0.0 ? 0.5 : 9.0;
    view.obstacles.clear();
    pane.show(view, {}, 0.1);
    const QImage picture = pictureOf(pane, {400, 400}, {});
    const int left = countOf(picture.copy(0, 0, 200, 400), colours().wall, 25),
              right = countOf(picture.copy(200, 0, 200, 400), colours().wall, 25);
    EXPECT_GT(left, 80) << "looked at just now";
    EXPECT_LT(right, 15) << "long ago";
}

TEST_P(Panes, TheWheelZoomsWithinBounds) {
    VirtualScanPane pane;
    pane.resize(300, 300);
    const double usual = pane.range();
    const auto turn = [&pane](int notches) {
        QWheelEvent event({100, 100}, {100, 100}, {}, {0, 120 * notches}, {}, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&pane, &event);
    };
    turn(1);
    EXPECT_LT(pane.range(), usual);
    turn(60);
    EXPECT_EQ(pane.range(), VirtualScanPane::NearestRange);
    turn(-120);
    EXPECT_EQ(pane.range(), VirtualScanPane::FarthestRange);
    QTest::mouseDClick(&pane, Qt::LeftButton);
    EXPECT_EQ(pane.range(), usual);
    QTest::keyClick(&pane, Qt::Key_Minus);
    EXPECT_GT(pane.range(), usual);
}

TEST_P(Panes, EveryModeHasItsBackgroundAndIsTheLargestText) {
    DriveStrip strip;
    const auto surface = [&] {
        strip.show(driveStateOf(robot));
        return countOf(pictureOf(strip, {760, 190}, {}).copy(4, 0, 230, 190),
                       modeLabelOf(robot.view, robot.reported.mode).kind == ModeKind::Stop ? colours().stop
                       : modeLabelOf(robot.view, robot.reported.mode).kind == ModeKind::Autonomous
                           ? colours().autonomous
                       : modeLabelOf(robot.view, robot.reported.mode).kind == ModeKind::Stopped
                           ? colours().stopped
                           : colours().teleoperation,
                       2);
    };
    constexpr int Most = 230 * 190 / 2;
    EXPECT_GT(surface(), Most);
    double largest = 0.0;
    std::string text;
    for (const PaintedText& one : paintedTexts(strip)) {
        if (one.box.height() > largest) largest = one.box.height(), text = one.text.toStdString();
    }
    EXPECT_EQ(text, "TELEOPERATION");
    setMode(robot, "explore", true);
    EXPECT_GT(surface(), Most);
    setMode(robot, "stopped");
    EXPECT_GT(surface(), Most);
    setStop(robot, true, true);
    EXPECT_GT(surface(), Most);
    robot.view.link.state = LinkState::Lost;
    robot.view.link.silence = 4.2;
    strip.show(driveStateOf(robot));
    const QImage lost = pictureOf(strip, {760, 190}, {}).copy(4, 0, 230, 190);
    EXPECT_GT(countOf(lost, colours().lost, 2), Most / 2);
    EXPECT_LT(countOf(lost, colours().lost, 2), 230 * 190 * 9 / 10) << "hatched";
}

TEST_P(Panes, TheStripSaysAllInEveryStateWithoutCuttingAWord) {
    for (const char* mode : {"teleoperation", "safe_teleoperation", "victim_approach", "stopped", "remote"}) {
        for (const int stop : {0, 1, 2, 3}) {
            SampleRobot one = sampleRobot();
            setMode(one, mode);
            if (stop > 0) setStop(one, stop > 1, stop > 2);
            one.view.drive.needsNeutral = true;
            DriveStrip strip;
            strip.show(driveStateOf(one));
            strip.resize(strip.minimumSizeHint());
            EXPECT_EQ(textFaults(strip).join("; ").toStdString(), "") << mode << ' ' << stop;
            strip.resize(760, 195);
            EXPECT_EQ(textFaults(strip).join("; ").toStdString(), "") << mode << ' ' << stop;
        }
    }
}

TEST_P(Panes, TheGrantIsAskedForAnsweredAndGivenUp) {
    DriveStrip strip;
    strip.resize(760, 190);
    QSignalSpy asked(&strip, &DriveStrip::grantAsked), given(&strip, &DriveStrip::grantGivenUp),
        answered(&strip, &DriveStrip::grantAnswered);
    auto* first = strip.findChild<QToolButton*>("grant");
    auto* second = strip.findChild<QToolButton*>("refuse");
    ASSERT_TRUE(first != nullptr && second != nullptr);
    strip.show(driveStateOf(robot));
    first->click();
    EXPECT_EQ(given.size(), 1);
    EXPECT_TRUE(second->isHidden());
    robot.view.grant.requestedBy = "van";
    strip.show(driveStateOf(robot));
    EXPECT_FALSE(second->isHidden());
    first->click();
    second->click();
    ASSERT_EQ(answered.size(), 2);
    EXPECT_TRUE(answered[0][0].toBool());
    EXPECT_FALSE(answered[1][0].toBool());
    robot.view.grant = {};
    strip.show(driveStateOf(robot));
    first->click();
    EXPECT_EQ(asked.size(), 1);
    EXPECT_EQ(first->text(), "Request");
}

TEST_P(Panes, StopActsOnPressAndKeepsItsPlace) {
    StopButton stop;
    stop.show();
    QSignalSpy stopped(&stop, &StopButton::stopRequested);
    QTest::mousePress(&stop, Qt::LeftButton);
    EXPECT_EQ(stopped.size(), 1) << "not only when it is let go";
    QTest::mouseRelease(&stop, Qt::LeftButton);
    EXPECT_EQ(stopped.size(), 1);
    EXPECT_EQ(stop.minimumSizeHint(), stop.sizeHint());
    EXPECT_GT(countOf(pictureOf(stop, stop.sizeHint(), {}), colours().stop, 2), 1500);
    EXPECT_EQ(textFaults(stop).join("; ").toStdString(), "");
    EXPECT_THAT(wordsOf(stop), Contains("Esc"));
}

TEST(ReleaseHandles, TakeAFullSecond) {
    SampleRobot robot = sampleRobot();
    RobotBar bar;
    bar.QWidget::show();
    const auto show = [&] {
        bar.show({robotChipOf(robot.face, robot.view, robot.reported, at(0))},
                 {stopLineOf(robot.face, robot.view)}, robot.face.name);
    };
    setStop(robot, true, true);
    show();
    bar.resize(240, bar.height());
    EXPECT_THAT(wordsOf(bar), Contains("standing · hold to release"));
    QSignalSpy released(&bar, &RobotBar::releaseRequested);
    auto* handle = bar.findChild<ReleaseHandle*>();
    ASSERT_NE(handle, nullptr);
    ASSERT_TRUE(handle->isVisible());
    QTest::mouseClick(handle, Qt::LeftButton);
    QTest::keyClick(handle, Qt::Key_Space);
    QTest::mousePress(handle, Qt::LeftButton);
    EXPECT_TRUE(handle->isHeld());
    QMouseEvent away(QEvent::MouseMove, QPointF(-30, 5), QPointF(-30, 5), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(handle, &away);
    EXPECT_FALSE(handle->isHeld()) << "the pointer left it";
    QElapsedTimer timer;
    timer.start();
    QTest::mousePress(handle, Qt::LeftButton);
    ASSERT_TRUE(released.wait(20'000));
    EXPECT_GE(timer.elapsed(), 999);
    EXPECT_EQ(released[0][0].toString(), robot.face.name);
    QTest::mouseRelease(handle, Qt::LeftButton);
    timer.start();
    QTest::keyPress(handle, Qt::Key_Space);
    ASSERT_TRUE(released.wait(20'000));
    EXPECT_GE(timer.elapsed(), 999);
    QTest::keyRelease(handle, Qt::Key_Space);
    EXPECT_EQ(released.size(), 2) << "clicks released nothing";
    robot.view.grant.mine = false;
    show();
    QTest::mousePress(handle, Qt::LeftButton);
    EXPECT_FALSE(handle->isHeld()) << "only the holder releases";
}

TEST_P(Panes, ARobotIsChosenByClickAndByKey) {
    RobotBar bar;
    const SampleRobot other = sampleRobot("C", "Crawler", 1);
    const std::vector<RobotChip> chips = {robotChipOf(robot.face, robot.view, robot.reported, at(0)),
                                          robotChipOf(other.face, other.view, other.reported, at(0))};
    bar.show(chips, {}, robot.face.name);
    bar.QWidget::show();
    QSignalSpy selected(&bar, &RobotBar::robotSelected);
    const auto buttons = bar.findChildren<RobotChipButton*>();
    ASSERT_EQ(buttons.size(), 2);
    EXPECT_TRUE(buttons[0]->isChecked());
    QTest::mouseClick(buttons[1], Qt::LeftButton);
    ASSERT_EQ(selected.size(), 1);
    EXPECT_EQ(selected[0][0].toString(), other.face.name);
    bar.show(chips, {}, other.face.name);
    EXPECT_FALSE(buttons[0]->isChecked());
    EXPECT_EQ(buttons[0]->shortcut(), QKeySequence("1"));
    for (const int width : {bar.minimumSizeHint().width(), bar.sizeHint().width(), bar.maximumWidth()}) {
        bar.resize(width, bar.height());
        EXPECT_EQ(textFaults(bar).join("; ").toStdString(), "") << width;
        EXPECT_THAT(wordsOf(bar), Contains(HasSubstr("71\u202f%"))) << width;
    }
}

TEST_P(Panes, EverythingHasANameForScreenReaders) {
    VirtualScanPane scan;
    scan.setRobot(robot.face, robot.description.footprint);
    scan.show(robot.view.around, {}, 0.1);
    EXPECT_THAT(scan.accessibleDescription().toStdString(), HasSubstr("0.91 m"));
    DriveStrip strip;
    strip.show(driveStateOf(robot));
    RobotBar bar;
    setStop(robot, true, true);
    bar.show({robotChipOf(robot.face, robot.view, robot.reported, at(0))},
             {stopLineOf(robot.face, robot.view)}, robot.face.name);
    const StopButton stop;
    EXPECT_FALSE(stop.accessibleName().isEmpty() || stop.toolTip().isEmpty());
    for (QWidget* top : {static_cast<QWidget*>(&strip), static_cast<QWidget*>(&bar)}) {
        for (QWidget* child : top->findChildren<QWidget*>()) {
            if (child->focusPolicy() == Qt::NoFocus || child->isHidden()) continue;
            EXPECT_FALSE(child->accessibleName().isEmpty()) << child->metaObject()->className();
            EXPECT_FALSE(child->toolTip().isEmpty()) << child->metaObject()->className();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Themes, Panes, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& info) { return info.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
