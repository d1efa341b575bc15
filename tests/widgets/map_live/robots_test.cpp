#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QHelpEvent>
#include <QLineF>
#include <QSignalSpy>
#include <QToolTip>

#include <gtest/gtest.h>

#include "tests/widgets/map_live/live_map.h"
#include "tests/widgets/map_view/golden.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

constexpr QRgb Amber = 0xFFE69F00, Trail = 0xFFCC79A7, KurtBlue = 0xFF56B4E9;

MapViewSettings following(MapFollow how, MapLook look = MapLook::Points) {
    MapViewSettings settings = settingsOf(look);
    settings.follow = how;
    return settings;
}

/// Kurt3D on a slope with a goal, and the Crawler in doubt.
std::vector<RobotMark> team() {
    RobotMark kurt = kurt3d(poseFrom({2.0, 0.3, RoomFloor + 0.1}, degrees(8), degrees(-10), degrees(20)));
    kurt.goalInMap = onFloor(3.6, -0.3, degrees(-90));
    RobotMark other = crawler(onFloor(1.2, -0.9, degrees(70)));
    other.doubtRadius = 0.6;
    other.note = QStringLiteral("place uncertain");
    other.tone = Tone::Attention;
    return {kurt, other};
}

/// For people: the picture in the folder LEITSTAND_PICTURES.
void lookAt(const QImage& picture, const QString& name) {
    const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
    if (!folder.isEmpty()) picture.save(folder + "/map_" + name + ".png");
}

TEST(RobotsOnTheMap, AreDrawnAsEver) {
    ShownView view(liveRoom(true), following(MapFollow::Behind));
    view->setRobots(team());
    view.settle();
    EXPECT_TRUE(looksLikeGolden(view->picture(), "robots-follow"));
    view.set(settingsOf(MapLook::Top, MapColouring::Label, Theme::Light));
    EXPECT_TRUE(looksLikeGolden(view->picture(), "robots-top-light"));
}

TEST(RobotsOnTheMap, PicturesForPeople) {
    if (qEnvironmentVariableIsEmpty("LEITSTAND_PICTURES"))
        GTEST_SKIP() << "SKIPPED: draws for people only: set LEITSTAND_PICTURES to a folder";
    ShownView view(liveRoom(true), {}, {1280, 800});
    view->setRobots(team());
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        for (const MapLook look : {MapLook::Points, MapLook::Voxels, MapLook::Top}) {
            for (const MapFollow follow : {MapFollow::Free, MapFollow::Behind, MapFollow::Above}) {
                MapViewSettings settings = following(follow, look);
                settings.theme = theme;
                view->setSettings(settings);
                view->setRobots(team());
                view.settle();
                lookAt(view->picture(), QStringLiteral("%1_%2_%3")
                                            .arg(theme == Theme::Dark ? "dark" : "light")
                                            .arg(static_cast<int>(look))
                                            .arg(static_cast<int>(follow)));
            }
        }
    }
}

TEST(RobotsOnTheMap, MoveWithoutDrawingThePointsAgain) {
    ShownView view(liveRoom(), settingsOf(MapLook::Top));
    QSignalSpy drawn(&*view, &MapView::becameSettled);
    RobotMark robot = kurt3d(onFloor(1, 0, 0));
    robot.trail = {};
    view->setRobots({robot});
    const QPoint here = view.at({1, 0, RoomFloor}).toPoint(), there = view.at({3, 0.5, RoomFloor}).toPoint();
    EXPECT_EQ(colourAt(view.onScreen(), here, 0), KurtBlue);
    robot.baseInMap = onFloor(3, 0.5, 0);
    view->setRobots({robot});
    const QImage moved = view.onScreen();
    EXPECT_EQ(colourAt(moved, there, 0), KurtBlue);
    EXPECT_NE(colourAt(moved, here, 0), KurtBlue);
    EXPECT_TRUE(view->settled());
    EXPECT_EQ(drawn.count(), 0);
}

TEST(RobotsOnTheMap, HaveTrails) {
    ShownView view(liveRoom(), settingsOf(MapLook::Top));
    EXPECT_GT(countPixels(view->picture(), Trail), 10) << "from scan to scan";
    view->setRobots({kurt3d(onFloor(3, 0, 0))});
    EXPECT_GT(countPixels(view->picture(), Trail), 80);
}

TEST(RobotsOnTheMap, TellUnderThePointerAndToScreenReadersHowSureTheirPlaceIs) {
    ShownView view(liveRoom(), settingsOf(MapLook::Top));
    RobotMark robot = kurt3d(onFloor(1, 0, 0));
    robot.details = QStringLiteral("Kurt3D: place certain to 83 %");
    view->setRobots({robot});
    view->setHint(QStringLiteral("Draw its place"));
    EXPECT_EQ(view->accessibleDescription(), QStringLiteral("Draw its place\nKurt3D: place certain to 83 %"));
    const auto reported = [&](const QPoint& at) {
        QHelpEvent help(QEvent::ToolTip, at, view->mapToGlobal(at));
        QApplication::sendEvent(&*view, &help);
        return QToolTip::text();
    };
    const QPoint there = view.at({1, 0, RoomFloor}).toPoint();
    EXPECT_EQ(reported(there + QPoint(150, 0)), QString());
    EXPECT_EQ(reported(there), robot.details);
    robot.details = QStringLiteral("Kurt3D: place uncertain, 12 %");
    view->setHint({});
    view->setRobots({robot});
    EXPECT_EQ(view->accessibleDescription(), robot.details);
}

TEST(RobotsOnTheMap, AtTheMapsEdgeTheirNoteIsNotCut) {
    ShownView view(liveRoom(), settingsOf(MapLook::Top));
    const auto pixelsOfNoteAt = [&](const Pose& place) {
        RobotMark robot = crawler(place);
        view->setRobots({robot});
        const QImage without = view.onScreen();
        robot.note = QStringLiteral("place uncertain");
        view->setRobots({robot});
        const QImage with = view.onScreen();
        int changed = 0;
        for (int y = 0; y < with.height(); ++y) {
            for (int x = 0; x < with.width(); ++x) changed += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
        }
        return changed;
    };
    Eigen::Vector3d edge(0.0, 0.0, RoomFloor);
    const Eigen::Vector3d aside = view.at({0, 0.1, RoomFloor}).x() > view.at({0, 0, RoomFloor}).x()
                                      ? Eigen::Vector3d(0, 0.01, 0)
                                      : Eigen::Vector3d(0, -0.01, 0);
    while (view.at(edge + aside).x() < view->width() - 20) edge += aside;
    const int inTheMiddle = pixelsOfNoteAt(onFloor(0.0, 0.0, 0.0));
    EXPECT_GT(inTheMiddle, 500);
    EXPECT_NEAR(pixelsOfNoteAt(onFloor(edge.x(), edge.y(), 0.0)), inTheMiddle, 0.1 * inTheMiddle);
}

TEST(RobotsOnTheMap, InDoubtHaveADashedAmberRing) {
    ShownView view(liveRoom(), settingsOf(MapLook::Top));
    RobotMark robot = crawler(onFloor(2, 0, 0));
    view->setRobots({robot});
    EXPECT_EQ(countPixels(view->picture(), Amber), 0) << "calm";
    robot.doubtRadius = 1.0;
    view->setRobots({robot});
    EXPECT_GT(countPixels(view->picture(), Amber), 30);
}

TEST(FollowView, HidesTheCeilingAndKeepsTheRobotInSight) {
    ShownView view(liveRoom(), following(MapFollow::Behind));
    view->setRobots({kurt3d(onFloor(1, 0, degrees(30)))});
    view.settle();
    EXPECT_EQ(countPixels(view->picture(), CeilingRed), 0);
    const Pose robot = onFloor(1, 0, degrees(30));
    const QPointF here = view.at(robot.translation()), ahead = view.at(robot * Eigen::Vector3d(1, 0, 0));
    EXPECT_TRUE(view->rect().contains(here.toPoint()));
    EXPECT_LT(ahead.y(), here.y());
    EXPECT_NEAR(ahead.x(), here.x(), 3) << "its heading is up";
    view.alter([](MapViewSettings& settings) { settings.follow = MapFollow::Free; });
    EXPECT_NEAR(view.at(robot.translation()).x(), here.x(), 3) << "the camera stays where it was";
}

TEST(FollowView, EndsWhenTheMapIsPulledAside) {
    ShownView view(liveRoom(), following(MapFollow::Above, MapLook::Top));
    view->setRobots({kurt3d(onFloor(1, 0, 0))});
    view.settle();
    QSignalSpy ended(&*view, &MapView::followEnded);
    view.wheel({240, 150}, 1);
    EXPECT_EQ(view->settings().follow, MapFollow::Above) << "zooming does not end it";
    view.drag(Qt::LeftButton, {200, 150}, {260, 170});
    EXPECT_EQ(ended.count(), 1);
    EXPECT_EQ(view->settings().follow, MapFollow::Free);
}

TEST(FollowView, AMapWithoutARobotIsFramedUntilOneIsThere) {
    ShownView framed(liveRoom(), settingsOf(MapLook::Top));
    ShownView view(liveRoom(), following(MapFollow::Above, MapLook::Top));
    const Eigen::Vector3d start(0, 0, RoomFloor), corner(3, 1, RoomFloor);
    for (const Eigen::Vector3d& place : {start, corner}) {
        EXPECT_NEAR(view.at(place).x(), framed.at(place).x(), 0.5);
        EXPECT_NEAR(view.at(place).y(), framed.at(place).y(), 0.5);
    }
    const Pose robot = onFloor(1, 0, degrees(30));
    view->setRobots({kurt3d(robot)});
    view.settle();
    const QPointF here = view.at(robot.translation()), ahead = view.at(robot * Eigen::Vector3d(1, 0, 0));
    EXPECT_NEAR(ahead.x(), here.x(), 3);
    EXPECT_LT(ahead.y(), here.y() - 10);
}

TEST(FollowView, ArrivesThoughNothingIsToldOfTheRobotAnyMore) {
    ShownView view(liveRoom(), following(MapFollow::Above, MapLook::Top));
    view->setRobots({kurt3d(onFloor(1, 0, 0))});
    view.settle();
    const QPointF before = view.at(onFloor(1, 0, 0).translation());
    view->setRobots({kurt3d(onFloor(2.5, 0.5, 0))});  // once: a review that stands
    const auto off = [&] {
        const auto now = view->project(onFloor(2.5, 0.5, 0).translation());
        return now ? QLineF(*now, before).length() : 1e9;
    };
    EXPECT_TRUE(waitFor([&] { return off() < 2.0 && view->settled(); })) << off() << " px off";
}

TEST(FollowView, TheFreeCameraIsRecalledAsItWasLeft) {
    ShownView view(liveRoom());
    view->setRobots({kurt3d(onFloor(1, 0, degrees(120)))});
    view.wheel({200, 120}, 2);
    view.settle();
    const Eigen::Vector3d near(2, 0.5, RoomFloor), far(3, 1, RoomFloor);
    const QPointF leftNear = view.at(near), leftFar = view.at(far);
    const auto off = [&] {
        return std::max(QLineF(view.at(near), leftNear).length(), QLineF(view.at(far), leftFar).length());
    };
    for (const MapLook look : {MapLook::Top, MapLook::Points}) {
        view->recall(following(MapFollow::Behind, look));
        view.settle();
        ASSERT_GT(off(), 10) << "it follows at once";
        view->recall(settingsOf(MapLook::Points));
        view.settle();
        EXPECT_LT(off(), 0.5);
    }
}

TEST(FollowView, AScanIsFramedOnRequest) {
    ShownView view(liveRoom(true));
    view.wheel({20, 20}, 6);
    view->showScan(2);
    view.settle();
    EXPECT_TRUE(view->rect().contains(view.at(liveRoom()->scans[1].poseInMap.translation()).toPoint()));
}

}  // namespace
}  // namespace leitstand::test
