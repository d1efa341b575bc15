#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/widgets/map_live/live_map.h"
#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"
#include "widgets/map_view/overlays/painted_cells.h"

namespace leitstand::test {
namespace {

constexpr std::size_t Points = 300'000;

MapPtr firstOf(const MapPtr& map, std::size_t scans) {
    auto first = std::make_shared<Map>(*map);
    first->scans.resize(scans);
    return first;
}

int differing(const QImage& a, const QImage& b) {
    EXPECT_EQ(a.size(), b.size());
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
    return count;
}

MapViewSettings behindKurt3d() {
    MapViewSettings settings;
    settings.follow = MapFollow::Behind;  // from the same place, however large the map is
    return settings;
}

/// A view that stands where @p map is seen from one place, however much of it is there.
void stand(ShownView& view) {
    view->setRobots({kurt3d(onFloor(0, 0, 0))});
    view.settle();
}

/// Few scans are drawn one by one; of many a sample is drawn first.
class GrowingMap : public testing::TestWithParam<std::size_t> {
protected:
    const MapPtr m_all = largeMap(Points, Points / GetParam());
    const std::size_t m_scans = m_all->scans.size();
};

TEST_P(GrowingMap, LooksAsIfItHadBeenThereAtOnce) {
    ShownView atOnce(m_all, behindKurt3d()), growing(firstOf(m_all, m_scans - 3), behindKurt3d());
    stand(atOnce);
    stand(growing);
    const QImage before = growing->picture();
    for (std::size_t count = m_scans - 2; count <= m_scans; ++count) {
        growing->setMap(firstOf(m_all, count));
        growing.settle();
    }
    // Which of points at one depth is in front is the order's in which they are drawn.
    EXPECT_LT(differing(growing->picture(), atOnce->picture()), 200);
    EXPECT_GT(differing(growing->picture(), before), 1'000) << "what came is to be seen";
}

TEST_P(GrowingMap, ShowsScansThatMoveMeanwhileAtTheirNewPlace) {
    auto moved = std::make_shared<Map>(*m_all);
    moved->scans[0].poseInMap.translation().z() += 0.3;
    ShownView atOnce(moved, behindKurt3d()), growing(firstOf(m_all, m_scans - 1), behindKurt3d());
    stand(atOnce);
    stand(growing);
    growing->setMap(moved);
    growing.settle();
    EXPECT_LT(differing(growing->picture(), atOnce->picture()), 200);
}

TEST_P(GrowingMap, ShowsWhatIsFartherThanAllBefore) {
    auto farther = std::make_shared<Map>(*m_all);
    farther->scans.push_back(mapOf({blob({60, 3, 2}, Label::Ceiling)})->scans[0]);
    farther->scans.back().id = 1'000;
    ShownView atOnce(farther, behindKurt3d()), growing(m_all, behindKurt3d());
    stand(atOnce);
    stand(growing);
    growing->setMap(farther);
    growing.settle();
    EXPECT_LT(differing(growing->picture(), atOnce->picture()), 200);
}

INSTANTIATE_TEST_SUITE_P(Scans, GrowingMap, testing::Values(6, 60),
                         [](const auto& info) { return info.param > 40 ? "Many" : "Few"; });

TEST(MapCamera, StandsStillWhileAMapGrowsWithinWhatItFrames) {
    const MapPtr all =
        mapOf({blob({4, 0, 0}, Label::Wall), blob({9, 6, 0}, Label::Wall), blob({9, -6, 0}, Label::Wall),
               blob({9, -6.1F, 0}, Label::Wall), blob({9, -9, 0}, Label::Wall)});
    ShownView view(firstOf(all, 3));
    view.settle();
    const QPointF before = view.at({4, 0, 0});
    view->setMap(firstOf(all, 4));
    view.settle();
    EXPECT_EQ(view.at({4, 0, 0}), before) << "a little";
    view->setMap(all);
    view.settle();
    EXPECT_NE(view.at({4, 0, 0}), before);
    EXPECT_TRUE(QRectF(view->rect()).contains(view.at({9, -9, 0})));
}

TEST(TrailsOnTheMap, LookTheSameHoweverOftenAWayWasDriven) {
    ShownView once(liveRoom(), settingsOf(MapLook::Top)), often(liveRoom(), settingsOf(MapLook::Top));
    RobotMark robot = kurt3d(onFloor(3, 0.5, 0));
    Trail way, ways;
    for (int i = 0; i <= 20; ++i)
        way.push_back({onFloor(1 + 0.1 * i, 0.025 * i, 0).translation().cast<float>()});
    for (int round = 0; round < 50; ++round) {
        ways.insert(ways.end(), way.begin(), way.end());
        ways.insert(ways.end(), way.rbegin(), way.rend());
    }
    ways.insert(ways.end(), way.begin(), way.end());
    robot.trail = std::make_shared<const Trail>(way);
    once->setRobots({robot});
    robot.trail = std::make_shared<const Trail>(ways);
    often->setRobots({robot});
    robot.trail = {};
    const QImage picture = once->picture();
    EXPECT_LT(differing(often->picture(), picture), 20);
    once->setRobots({robot});
    EXPECT_GT(differing(once->picture(), picture), 100) << "the trail is to be seen";
}

/// Whether @p part of a picture has the colour of trails.
bool isTrail(const QImage& part) {
    const QColor trail("#CC79A7");
    for (int y = 0; y < part.height(); ++y) {
        for (int x = 0; x < part.width(); ++x) {
            const QColor here = part.pixelColor(x, y);
            const int off = std::abs(here.red() - trail.red()) + std::abs(here.green() - trail.green()) +
                            std::abs(here.blue() - trail.blue());
            if (off < 20) return true;
        }
    }
    return false;
}

TEST(TrailsOnTheMap, NoLineGoesWhereNobodyKnowsTheWay) {
    ShownView view(liveRoom(), settingsOf(MapLook::Top));
    RobotMark robot = kurt3d(onFloor(3, 0.5, 0));
    const auto trail = [](bool gap) {
        Trail way;
        for (int i = 0; i <= 5; ++i)
            way.push_back({onFloor(0.5 + 0.1 * i, -0.8, 0).translation().cast<float>()});
        for (int i = 0; i <= 5; ++i)
            way.push_back({onFloor(2.2 + 0.1 * i, 0.5, 0).translation().cast<float>(), gap && i == 0});
        return std::make_shared<const Trail>(way);
    };
    const auto painted = [&](double fromX, double fromY, double toX, double toY) {
        const QImage picture = view->picture();
        int found = 0;
        for (double t = 0.1; t <= 0.9; t += 0.01) {
            const QPointF at = view.at({fromX + t * (toX - fromX), fromY + t * (toY - fromY), RoomFloor});
            found += isTrail(picture.copy(QRect(at.toPoint() - QPoint(2, 2), QSize(5, 5)))) ? 1 : 0;
        }
        return found;
    };
    robot.trail = trail(false);
    view->setRobots({robot});
    EXPECT_GT(painted(1.0, -0.8, 2.2, 0.5), 40);
    EXPECT_GT(painted(0.5, -0.8, 1.0, -0.8), 40);
    robot.trail = trail(true);
    view->setRobots({robot});
    EXPECT_EQ(painted(1.0, -0.8, 2.2, 0.5), 0);
    EXPECT_GT(painted(0.5, -0.8, 1.0, -0.8), 40);
    robot.baseInMap = onFloor(4.4, -0.9, 0);
    view->setRobots({robot});
    EXPECT_GT(painted(2.8, 0.4, 4.2, -0.8), 20);
    robot.afterGap = true;
    view->setRobots({robot});
    EXPECT_EQ(painted(2.8, 0.4, 4.2, -0.8), 0) << "nor to the robot";
}

TEST(TrailsOnTheMap, ScansOfARobotThatIsNotPlacedAreJoinedOnlyWhereItsWayIsKnown) {
    constexpr QRgb Colour = 0xFFCC79A7;
    auto map = std::make_shared<Map>(*liveRoom());
    ShownView view(map, settingsOf(MapLook::Top));
    EXPECT_GT(countPixels(view->picture(), Colour), 10) << "files tell their order only";
    auto live = std::make_shared<Map>(*map);
    for (std::size_t i = 0; i < live->scans.size(); ++i) {
        MapScan& scan = live->scans[i];
        scan.entered = Time(std::chrono::seconds(1000 + 2 * i));
        scan.poseInMap.translation() =
            map->scans[0].poseInMap.translation() + Eigen::Vector3d(0.9 * static_cast<double>(i), 0, 0);
    }
    view->setMap(live);
    view.settle();
    EXPECT_GT(countPixels(view->picture(), Colour), 10);
    auto resumed = std::make_shared<Map>(*live);
    for (std::size_t i = 0; i < live->scans.size(); ++i)
        resumed->scans[i].poseInMap.translation().x() =
            map->scans[0].poseInMap.translation().x() + 1.2 * static_cast<double>(i);
    view->setMap(resumed);
    view.settle();
    EXPECT_EQ(countPixels(view->picture(), Colour), 0);
}

TEST(PaintedCellsTest, PlacesAreNewOnce) {
    PaintedCells cells({100, 50}, 2.0);
    EXPECT_TRUE(cells.take({10.0, 10.0}));
    EXPECT_FALSE(cells.take({11.9, 11.9}));
    EXPECT_TRUE(cells.take({12.1, 10.0}));
    EXPECT_TRUE(cells.takeLine({0.0, 30.0}, {99.0, 30.0}));
    EXPECT_FALSE(cells.takeLine({90.0, 31.0}, {5.0, 31.0}));
    EXPECT_TRUE(cells.takeLine({50.0, 31.0}, {50.0, 40.0})) << "its end is new";
}

TEST(PaintedCellsTest, NothingOutsideIsNew) {
    constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
    PaintedCells cells({100, 50}, 2.0);
    EXPECT_FALSE(cells.take({-0.1, 10.0}));
    EXPECT_FALSE(cells.take({100.1, 10.0}));
    EXPECT_FALSE(cells.take({1e300, 1e300}));
    EXPECT_FALSE(cells.take({Nan, 10.0}));
    EXPECT_FALSE(cells.takeLine({-50.0, -1.0}, {200.0, -1.0}));
    EXPECT_FALSE(cells.takeLine({Nan, 1.0}, {5.0, 5.0}));
    EXPECT_TRUE(cells.takeLine({-50.0, 20.0}, {200.0, 20.0})) << "it passes through";
    EXPECT_TRUE(cells.takeLine({-1e9, 20.0}, {1e9, 20.0}));
}

TEST(PaintedCellsTest, AnEmptyWidgetHasNoPlaces) {
    PaintedCells cells({0, 0}, 2.0);
    EXPECT_FALSE(cells.take({0.0, 0.0}));
    EXPECT_FALSE(cells.takeLine({-1.0, -1.0}, {1.0, 1.0}));
}

}  // namespace
}  // namespace leitstand::test
