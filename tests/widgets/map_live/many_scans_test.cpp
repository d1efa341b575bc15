#include <gtest/gtest.h>

#include "tests/widgets/map_live/live_map.h"
#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

constexpr std::size_t Points = 400'000, Scans = 50;  // of so many scans a sample is drawn first

/// Pixels that a point covers in one picture, and none in the other. (Which of those at one depth is in front
/// is the order's in which they are drawn.)
int differing(const QImage& a, const QImage& b) {
    EXPECT_EQ(a.size(), b.size());
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x)
            count += (a.pixel(x, y) == DarkBackground) != (b.pixel(x, y) == DarkBackground) ? 1 : 0;
    }
    return count;
}

/// The points of largeMap() in a single scan.
MapPtr inOneScan(const MapPtr& map) {
    std::vector<Eigen::Vector3f> points;
    std::vector<Label> labels;
    for (const MapScan& one : map->scans) {
        points.insert(points.end(), one.scan->points.begin(), one.scan->points.end());
        labels.insert(labels.end(), one.scan->labels.begin(), one.scan->labels.end());
    }
    auto scan = std::make_shared<Scan>();
    scan->name = "all";
    scan->points = std::move(points);
    scan->labels = std::move(labels);
    return mapOf(std::vector<ScanPtr>{scan});
}

class ManyScans : public testing::Test {
protected:
    /// Nothing but a mark tells how many scans a complete picture is made of.
    void expectAlike(MapViewSettings settings) {
        settings.follow = MapFollow::Behind;  // from the same place, whatever there is to be framed
        for (ShownView* view : {&m_many, &m_one}) {
            (*view)->setSettings(settings);
            (*view)->setRobots({kurt3d(onFloor(0, 0, 0))});
            EXPECT_TRUE(view->settle());
        }
        const QImage many = m_many->picture(), one = m_one->picture();
        QImage empty(one.size(), one.format());
        empty.fill(DarkBackground);
        EXPECT_GT(differing(one, empty), 10'000) << "something is to be seen";
        // The mark of where a scan was taken is smaller where there are many.
        EXPECT_LT(differing(many, one), 100);
    }

    const MapPtr m_map = largeMap(Points, Points / Scans);
    ShownView m_many{m_map}, m_one{inOneScan(m_map)};
};

TEST_F(ManyScans, LookAsTheirPointsInOneScan) {
    expectAlike({});
    expectAlike(settingsOf(MapLook::Top));
    MapViewSettings cut;
    cut.minHeight = 0.2;
    cut.maxHeight = 1.2;
    expectAlike(cut);
}

TEST_F(ManyScans, HideTheirPointsWithThem) {
    const QImage all = m_many->picture();
    std::vector<bool> none(Scans, false);
    m_many->setVisible(none);
    EXPECT_TRUE(m_many.settle());
    EXPECT_EQ(countPixels(m_many->picture(), WallYellow), 0);
    none.assign(Scans, true);
    none[0] = false;  // still many
    m_many->setVisible(none);
    EXPECT_TRUE(m_many.settle());
    EXPECT_GT(countPixels(m_many->picture(), WallYellow), 1'000);
    m_many->setVisible(std::vector<bool>(Scans, true));
    EXPECT_TRUE(m_many.settle());
    EXPECT_LT(differing(m_many->picture(), all), 10);
}

}  // namespace
}  // namespace leitstand::test
