#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"
#include "widgets/map_view/camera/map_camera.h"

namespace leitstand::test {
namespace {

/// Three blobs: ahead in blue, to the left in yellow, above in red.
MapPtr axesMap() {
    return mapOf({blob({5, 0, 0}, Label::Floor), blob({3, 2, 0}, Label::Wall),
                  blob({3, 0, 2}, Label::Ceiling), blob({3, -2, 0}, Label::Unlabelled)});
}

const Eigen::Vector3d Ahead(5, 0, 0), Left(3, 2, 0), Above(3, 0, 2), Right(3, -2, 0);

double distance(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

TEST(MapCamera, PointsAreDrawnWhereTheyAreProjected) {
    ShownView view(axesMap());
    const auto expectColours = [&view] {
        const QImage picture = view->picture();
        EXPECT_EQ(colourAt(picture, view.at(Ahead), DarkBackground), FloorBlue);
        EXPECT_EQ(colourAt(picture, view.at(Left), DarkBackground), WallYellow);
        EXPECT_EQ(colourAt(picture, view.at(Above), DarkBackground), CeilingRed);
    };
    expectColours();
    view->setCamera(CameraPreset::Side);
    expectColours();
    view.drag(Qt::LeftButton, {240, 150}, {300, 190});
    expectColours();
    view.wheel({200, 100}, 2);
    expectColours();
}

TEST(MapCamera, ResetLooksForwardFromBehindAndAbove) {
    ShownView view(axesMap());
    EXPECT_LT(view.at(Left).x(), view.at(Right).x());
    EXPECT_LT(view.at(Above).y(), view.at({3, 0, 0}).y() - 10);
    EXPECT_LT(view.at({8, 0, 0}).y(), view.at({3, 0, 0}).y()) << "farther ahead is higher up";
    // What is ahead is farther away: a metre across looks smaller there.
    EXPECT_LT(distance(view.at({8, 0, 0}), view.at({8, 0, 1})),
              distance(view.at({2, 0, 0}), view.at({2, 0, 1})));
}

TEST(MapCamera, OfAFloorThatReachesBehindTheEyeTheRestIsOutlined) {
    MapCamera camera;
    camera.focus = {2, 0, 0.4};
    camera.pitch = 0.3;
    camera.distance = 2.0;
    const MapProjection projection(camera, {400, 300});
    const auto floor = [](double from, double to) {
        return std::array<Eigen::Vector3d, 4>{{{from, -3, 0}, {to, -3, 0}, {to, 3, 0}, {from, 3, 0}}};
    };
    const QPolygonF outline = projection.outline(floor(-6, 6));
    for (const Eigen::Vector3d& ahead : {Eigen::Vector3d(1.5, 0, 0), {3, 1, 0}, {5, -2, 0}})
        EXPECT_TRUE(outline.containsPoint(projection.project(ahead)->position, Qt::OddEvenFill)) << ahead.x();
    const QPointF above = projection.project({5, 0, 1.5})->position;
    EXPECT_FALSE(outline.containsPoint(above, Qt::OddEvenFill)) << "nothing of the wall behind it";
    EXPECT_TRUE(projection.outline(floor(-6, -3)).isEmpty());
    EXPECT_EQ(projection.outline(floor(3, 5)).size(), 4);
}

TEST(MapCamera, TopLooksStraightDownWithForwardUp) {
    ShownView view(axesMap());
    view->setCamera(CameraPreset::Top);
    view.settle();
    EXPECT_LT(view.at({5, 0, 0}).y(), view.at({3, 0, 0}).y() - 10);
    EXPECT_LT(view.at(Left).x(), view.at({3, 0, 0}).x() - 10);
    EXPECT_NEAR(view.at({3, 0, 0}).x(), view.at({5, 0, 0}).x(), 1.0);
}

TEST(MapCamera, SideShowsHeightsUpright) {
    ShownView view(axesMap());
    view->setCamera(CameraPreset::Side);
    view.settle();
    EXPECT_NEAR(view.at({3, 0, 0}).x(), view.at(Above).x(), 1.0);
    EXPECT_LT(view.at(Above).y(), view.at({3, 0, 0}).y() - 10);
    EXPECT_GT(std::abs(view.at({5, 0, 0}).x() - view.at({3, 0, 0}).x()), 10);
}

TEST(MapCamera, TopLookIsOrthographicAndKeepsTheFreeCamera) {
    ShownView view(axesMap());
    view.drag(Qt::LeftButton, {240, 150}, {280, 150});
    const QPointF before = view.at(Above);
    view.alter([](MapViewSettings& settings) { settings.look = MapLook::Top; });
    EXPECT_LT(distance(view.at({3, 1, 0}), view.at({3, 1, 2})), 0.5) << "heights are not seen";
    EXPECT_NEAR(distance(view.at({3, 0, 0}), view.at({4, 0, 0})),
                distance(view.at({5, 0, 2}), view.at({6, 0, 2})), 0.1);
    view.alter([](MapViewSettings& settings) { settings.look = MapLook::Points; });
    EXPECT_LT(distance(view.at(Above), before), 0.1);
}

TEST(MapCamera, WholeMapIsInThePictureDespiteStrayPoints) {
    auto stray = std::make_shared<Scan>(*blob({0, 0, 0}, Label::Wall));
    for (std::size_t i = 0; i < 40; ++i) stray->points[i] = {29.0F, float(i) / 100, 0.0F};
    ShownView view(
        mapOf({blob({5, 2, 0}, Label::Wall), blob({5, -2, 1}, Label::Wall), blob({2, 0, -1}, Label::Wall),
               blob({4, 1, 0}, Label::Wall), blob({4, -1, 0}, Label::Wall), stray}));
    const QRectF inside = QRectF(view->rect()).adjusted(2, 2, -2, -2);
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(5, 2, 0), Eigen::Vector3d(5, -2, 1), Eigen::Vector3d(2, 0, -1)}) {
        EXPECT_TRUE(inside.contains(view.at(point)));
    }
    EXPECT_GT(distance(view.at({5, 2, 0}), view.at({5, -2, 1})), 120) << "the stray points shrink the map";
}

TEST(MapCamera, LeftDragTurnsTheMapWithTheMouse) {
    ShownView view(axesMap());
    const QImage before = view->picture();
    // Of two points, one nearer than what is turned about, one farther: they move against each other.
    const double near = view.at({1, -1.5, 0}).x(), far = view.at({9, 2, 0}).x();
    view.drag(Qt::LeftButton, {240, 150}, {300, 150});
    EXPECT_NE(view->picture(), before);
    EXPECT_GT(view.at({1, -1.5, 0}).x() - near, view.at({9, 2, 0}).x() - far + 10);
}

TEST(MapCamera, DownwardDragLooksMoreFromAbove) {
    ShownView view(axesMap());
    const double height = distance(view.at(Above), view.at({3, 0, 0}));
    view.drag(Qt::LeftButton, {240, 100}, {240, 180});
    EXPECT_LT(distance(view.at(Above), view.at({3, 0, 0})), height - 5);
}

TEST(MapCamera, MiddleAndShiftedDragCarryThePointUnderTheMouse) {
    ShownView view(axesMap());
    const auto expectCarried = [&view](Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
        const QPoint start = view.at(Ahead).toPoint();
        view.drag(button, start, start + QPoint(-40, 25), modifiers);
        EXPECT_LT(distance(view.at(Ahead), start + QPoint(-40, 25)), 8);
    };
    expectCarried(Qt::MiddleButton, {});
    expectCarried(Qt::LeftButton, Qt::ShiftModifier);
    view.alter([](MapViewSettings& settings) { settings.look = MapLook::Top; });
    expectCarried(Qt::LeftButton, {});
}

TEST(MapCamera, WheelZoomsTowardsThePointer) {
    for (const MapLook look : {MapLook::Points, MapLook::Top}) {
        ShownView view(axesMap(), settingsOf(look));
        const QPoint pointer = view.at(Left).toPoint();
        const double size = distance(view.at(Left), view.at({3, 2.5, 0}));
        view.wheel(pointer, 3);
        EXPECT_LT(distance(view.at(Left), pointer), 6);
        EXPECT_GT(distance(view.at(Left), view.at({3, 2.5, 0})), 1.2 * size);
        view.wheel(pointer, -6);
        EXPECT_LT(distance(view.at(Left), view.at({3, 2.5, 0})), 0.9 * size);
    }
}

TEST(MapCamera, RightDragZooms) {
    ShownView view(axesMap());
    const double size = distance(view.at(Left), view.at(Right));
    view.drag(Qt::RightButton, {240, 200}, {240, 140});
    EXPECT_GT(std::abs(distance(view.at(Left), view.at(Right)) / size - 1), 0.15);
}

TEST(MapCamera, KeysTurnShiftAndZoom) {
    ShownView view(axesMap());
    const auto changes = [&view](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        const QPointF left = view.at(Left), ahead = view.at(Ahead);
        view.press(key, modifiers);
        return distance(view.at(Left), left) + distance(view.at(Ahead), ahead);
    };
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}) {
        EXPECT_GT(changes(key), 4);
        EXPECT_GT(changes(key, Qt::ShiftModifier), 4);
    }
    const double size = distance(view.at(Left), view.at(Right));
    view.press(Qt::Key_Plus);
    const double larger = distance(view.at(Left), view.at(Right));
    EXPECT_GT(larger, 1.05 * size);
    view.press(Qt::Key_Minus);
    EXPECT_NEAR(distance(view.at(Left), view.at(Right)), size, 0.05 * size);
}

TEST(MapCamera, ResetComesBackToTheFirstPicture) {
    ShownView view(axesMap());
    const QPointF left = view.at(Left), ahead = view.at(Ahead);
    view.drag(Qt::LeftButton, {240, 150}, {330, 120});
    view.wheel({100, 100}, 4);
    view->setCamera(CameraPreset::Reset);
    view.settle();
    EXPECT_LT(distance(view.at(Left), left), 1);
    EXPECT_LT(distance(view.at(Ahead), ahead), 1);
}

TEST(MapCamera, HidingClippingAndComparingLeaveTheCameraWhereItIs) {
    const auto map = std::make_shared<Map>(*axesMap());
    map->scans[1].guessInMap = poseFrom({0, 2, 0}, 0, 0, 0);
    ShownView view(map);
    const QPointF ahead = view.at(Ahead);
    view->setVisible({true, false, true});
    view.settle();
    EXPECT_LT(distance(view.at(Ahead), ahead), 0.1) << "hiding a scan moved the camera";
    view.alter([](MapViewSettings& settings) { settings.maxHeight = 1.0; });
    EXPECT_LT(distance(view.at(Ahead), ahead), 0.1) << "clipping moved the camera";
    view.alter([](MapViewSettings& settings) { settings.poses = MapPoses::Guess; });
    EXPECT_LT(distance(view.at(Ahead), ahead), 0.1) << "showing the guess moved the camera";
    view.alter([](MapViewSettings& settings) { settings.look = MapLook::Voxels; });
    EXPECT_LT(distance(view.at(Ahead), ahead), 0.1) << "voxels moved the camera";
}

TEST(MapCamera, GrowingMapStaysInThePictureUntilTheCameraIsMoved) {
    const MapPtr all =
        mapOf({blob({4, 0, 0}, Label::Wall), blob({9, 6, 0}, Label::Wall), blob({9, -6, 0}, Label::Wall)});
    auto first = std::make_shared<Map>(*all);
    first->scans.resize(1);
    ShownView view(first);
    view->setMap(all);
    view.settle();
    EXPECT_TRUE(QRectF(view->rect()).contains(view.at({9, 6, 0})));
    EXPECT_TRUE(QRectF(view->rect()).contains(view.at({9, -6, 0})));
}

TEST(MapCamera, MovedCameraStaysWhenScansAreAdded) {
    const MapPtr all = axesMap();
    auto first = std::make_shared<Map>(*all);
    first->scans.resize(2);
    ShownView view(first);
    view.drag(Qt::LeftButton, {240, 150}, {280, 150});
    const QPointF left = view.at(Left);
    view->setMap(all);
    view.settle();
    EXPECT_LT(distance(view.at(Left), left), 0.1);
}

}  // namespace
}  // namespace leitstand::test
