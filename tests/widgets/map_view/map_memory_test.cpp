// Memory of the process, that of OpenGL included where it draws in software.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/heap.h"
#include "tests/support/resident_memory.h"
#include "tests/widgets/map_view/shown_view.h"

namespace leitstand::test {
namespace {

constexpr std::size_t PointsOfScan = 13'400;  ///< as a simulated Kurt3D's key scans have
constexpr double MostMegabytesAScan = 0.4;    ///< with its points: the live map has more of it

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

struct Taken {
    unsigned scans = 0;
    double megabytes = 0.0;
};

/// What the process takes with more and more scans, which come some at a time and are all drawn. OpenGL that
/// draws in software keeps some of what it drew last, 28 MB and more, and when it lets go of that is its own
/// affair: less of it is there while the camera looks at none of them.
std::vector<Taken> growing(ShownView& view) {
    std::vector<Taken> taken;
    Map map;
    for (unsigned count = 75; count <= 375; count += 50) {
        while (map.scans.size() < count)
            map.scans.push_back(keyScan(static_cast<unsigned>(map.scans.size() + 1)));
        view->setMap(std::make_shared<const Map>(map));
        EXPECT_TRUE(view.settle());
        view.drag(Qt::LeftButton, {200, 150}, {220, 160});
        EXPECT_TRUE(view.settle());
        view->showPlace({0.0, 0.0, -1000.0});
        EXPECT_TRUE(view.settle());
        returnFreeHeap();
        taken.push_back({count, residentMegabytes()});
        view->setCamera(CameraPreset::Reset);
    }
    return taken;
}

/// What a scan takes: the median of what any two of @p taken say (Theil and Sen), since some are off.
double megabytesEach(const std::vector<Taken>& taken) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < taken.size(); ++i) {
        for (std::size_t j = i + 1; j < taken.size(); ++j)
            slopes.push_back((taken[j].megabytes - taken[i].megabytes) / (taken[j].scans - taken[i].scans));
    }
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle;
}

TEST(MapViewMemory, AKeyScanThatIsShownTakesLittleMoreThanItsPoints) {
    ShownView view(nullptr, settingsOf(MapLook::Points, MapColouring::Height), {640, 400});
    const std::vector<Taken> taken = growing(view);
    const double each = megabytesEach(taken);
    for (const Taken& one : taken)
        std::printf("[          ] %u key scans: %.0f MB\n", one.scans, one.megabytes);
    std::printf("[          ] %.3f MB each\n", each);
    EXPECT_LE(each, MostMegabytesAScan);
}

}  // namespace
}  // namespace leitstand::test
