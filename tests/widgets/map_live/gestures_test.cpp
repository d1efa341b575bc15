#include <cmath>

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include "tests/widgets/map_live/live_map.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

using Area = std::vector<Eigen::Vector2d>;

/// A view from above, and what was drawn in it.
class Gestures : public testing::Test {
protected:
    Gestures() {
        m_view->setGround(RoomFloor);
        QObject::connect(&*m_view, &MapView::poseDrawn, &*m_view,
                         [this](const GroundPose& pose) { m_pose = pose; });
        QObject::connect(&*m_view, &MapView::areaDrawn, &*m_view,
                         [this](const Area& area) { m_area = area; });
    }
    [[nodiscard]] QPoint over(double x, double y) { return m_view.at({x, y, RoomFloor}).toPoint(); }

    ShownView m_view{liveRoom(), settingsOf(MapLook::Top)};
    std::optional<GroundPose> m_pose;
    Area m_area;
};

TEST_F(Gestures, PressIsThePlaceAndADragTheHeading) {
    m_view->startPose(kurt3d(onFloor(0, 0, 0)));
    m_view.drag(Qt::LeftButton, over(2, 0), over(2, 1.5));
    ASSERT_TRUE(m_pose);
    EXPECT_NEAR(m_pose->place.x(), 2, 0.05);
    EXPECT_NEAR(m_pose->place.y(), 0, 0.05);
    EXPECT_NEAR(m_pose->place.z(), RoomFloor, 0.06);
    ASSERT_TRUE(m_pose->heading);
    EXPECT_NEAR(*m_pose->heading, degrees(90), degrees(5));
}

TEST_F(Gestures, AClickHasNoHeading) {
    m_view->startPose(kurt3d(onFloor(0, 0, 0)));
    m_view.click(over(1, -1));
    ASSERT_TRUE(m_pose);
    EXPECT_FALSE(m_pose->heading);
}

TEST_F(Gestures, TheRightButtonEndsItWithoutAPose) {
    QSignalSpy ended(&*m_view, &MapView::gestureEnded);
    m_view->startPose(kurt3d(onFloor(0, 0, 0)));
    QTest::mouseClick(&*m_view, Qt::RightButton, {}, over(1, 0));
    EXPECT_EQ(ended.count(), 1);
    EXPECT_FALSE(m_view->drawing());
    m_view.click(over(1, 0));
    EXPECT_FALSE(m_pose);
}

TEST_F(Gestures, WithoutOneTheMouseMovesTheMap) {
    const QPointF before = m_view.at({2, 0, RoomFloor});
    m_view.drag(Qt::LeftButton, over(2, 0), over(2, 0) + QPoint(40, 0));
    EXPECT_GT(m_view.at({2, 0, RoomFloor}).x(), before.x() + 20);
    EXPECT_FALSE(m_pose);
}

TEST_F(Gestures, ADoubleClickIsAPlaceToGoTo) {
    QSignalSpy activated(&*m_view, &MapView::groundActivated);
    QTest::mouseDClick(&*m_view, Qt::LeftButton, {}, over(1.5, 0.5));
    ASSERT_EQ(activated.count(), 1);
    const auto place = activated[0][0].value<Eigen::Vector3d>();
    EXPECT_NEAR(place.x(), 1.5, 0.05);
    EXPECT_NEAR(place.y(), 0.5, 0.05);
}

TEST_F(Gestures, WorkInAPerspectiveToo) {
    MapViewSettings settings;
    settings.follow = MapFollow::Behind;
    m_view->setSettings(settings);
    m_view->setRobots({kurt3d(onFloor(0, 0, 0))});
    m_view.settle();
    m_view->startPose(kurt3d(onFloor(0, 0, 0)));
    m_view.click(over(2, 0.4));
    ASSERT_TRUE(m_pose);
    EXPECT_NEAR(m_pose->place.x(), 2, 0.15);
    EXPECT_NEAR(m_pose->place.y(), 0.4, 0.15);
}

TEST_F(Gestures, AnAreaIsCornersAndADoubleClick) {
    m_view->startArea();
    for (const QPoint corner : {over(-1, -1), over(3, -1), over(3, 1), over(0, 1)}) m_view.click(corner);
    QTest::mouseClick(&*m_view, Qt::RightButton, {}, over(0, 0));  // takes the last one back
    m_view.click(over(-1, 1));
    QTest::mouseDClick(&*m_view, Qt::LeftButton, {}, over(-1, 1));
    ASSERT_EQ(m_area.size(), 4U);
    EXPECT_NEAR(m_area[1].x(), 3, 0.05);
    EXPECT_NEAR(m_area[3].x(), -1, 0.05);
}

}  // namespace
}  // namespace leitstand::test
