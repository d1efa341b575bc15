// Memory of the process, that of OpenGL included where it draws in software.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/base/heap.h"
#include "tests/support/resident_memory.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

constexpr std::size_t PointsOfScan = 13'400;  ///< as a simulated Kurt3D's key scans have
constexpr double MostMegabytesAScan = 0.3;    ///< with its points: the live map has more of it

/// What a live map keeps of a scan: points in upright rows around the scanner, all of them within its range.
MapScan keyScan(unsigned number) {
    constexpr std::size_t Row = 80;
    auto scan = std::make_shared<Scan>();
    scan->points.reserve(PointsOfScan);
    for (std::size_t i = 0; i < PointsOfScan; ++i) {
        const float angle = 6.28F * static_cast<float>(i / Row) / static_cast<float>(PointsOfScan / Row);
        const float range = 2.5F + std::sin(3.0F * angle + 0.1F * static_cast<float>(number));
        scan->points.emplace_back(range * std::cos(angle), range * std::sin(angle),
                                  -0.5F + 0.02F * static_cast<float>(i % Row));
    }
    scan->labels.assign(PointsOfScan, Label::Wall);
    scan->shades.assign(PointsOfScan, 100);
    MapScan placed;
    placed.scan = scan;
    placed.id = number;
    placed.poseInMap.translation() = Eigen::Vector3d(0.01 * number, 0.0, 0.0);
    return placed;
}

/// Memory that a view of @p count scans takes, which are all drawn.
double shown(ShownView& view, Map& map, unsigned count) {
    while (map.scans.size() < count) {
        map.scans.push_back(keyScan(static_cast<unsigned>(map.scans.size() + 1)));
        if (map.scans.size() % 25 != 0) continue;  // as they come, and seen from elsewhere
        view->setMap(std::make_shared<const Map>(map));
        EXPECT_TRUE(view.settle());
        view.drag(Qt::LeftButton, {200, 150}, {220, 160});
        EXPECT_TRUE(view.settle());
    }
    returnFreeHeap();
    return residentMegabytes();
}

TEST(MapViewMemory, AKeyScanThatIsShownTakesLittleMoreThanItsPoints) {
    ShownView view(nullptr, settingsOf(MapLook::Points, MapColouring::Height), {640, 400});
    Map map;
    const double before = shown(view, map, 75), after = shown(view, map, 275);
    const double each = (after - before) / 200.0;
    std::printf("[          ] %.0f MB with 75 key scans, %.0f MB with 275: %.3f MB each\n", before, after,
                each);
    EXPECT_LE(each, MostMegabytesAScan);
}

}  // namespace
}  // namespace leitstand::test
