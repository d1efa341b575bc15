#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <set>

#include <gtest/gtest.h>

#include "tests/widgets/map_view/golden.h"
#include "tests/widgets/map_view/maps.h"
#include "tests/widgets/map_view/shown_view.h"
#include "widgets/models/map/robots/robot_mark.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

/// A room of two scans, shared by the tests: making it takes its time.
const MapPtr& room() {
    static const MapPtr map = roomMap();
    return map;
}

struct Look {
    std::string name;
    MapViewSettings settings;
};

/// What gtest calls a look.
void PrintTo(const Look& look, std::ostream* out) {
    *out << look.name;
}

class GoldenPicture : public testing::TestWithParam<Look> {};

TEST_P(GoldenPicture, IsDrawnAsEver) {
    ShownView view(room(), GetParam().settings);
    EXPECT_TRUE(looksLikeGolden(view->picture(), GetParam().name));
}

std::vector<Look> looks() {
    MapViewSettings voxels = voxelsOf(0.15);
    voxels.maxHeight = 1.2;
    return {
        {"points", {}},
        {"points-by-height", settingsOf(MapLook::Points, MapColouring::Height)},
        {"points-by-range", settingsOf(MapLook::Points, MapColouring::Range)},
        {"points-by-scan-light", settingsOf(MapLook::Points, MapColouring::Scan, Theme::Light)},
        {"voxels", voxels},
        {"top", settingsOf(MapLook::Top)},
        {"top-light", settingsOf(MapLook::Top, MapColouring::Label, Theme::Light)},
    };
}

INSTANTIATE_TEST_SUITE_P(Looks, GoldenPicture, testing::ValuesIn(looks()), [](const auto& info) {
    std::string name = info.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
});

TEST(MapLooks, ShowFloorWallAndCeilingInTheirColours) {
    ShownView view(room());
    const QImage picture = view->picture();
    EXPECT_GT(countPixels(picture, WallYellow), 1'000);
    EXPECT_GT(countPixels(picture, CeilingRed), 1'000);
    view.alter([](MapViewSettings& settings) { settings.maxHeight = 1.0; });
    EXPECT_GT(countPixels(view->picture(), FloorBlue), 1'000);
}

TEST(MapLooks, TopLookLetsOneSeeIntoTheRoomsOntoLightGround) {
    ShownView view(room(), settingsOf(MapLook::Top));
    const QImage picture = view->picture();
    EXPECT_EQ(countPixels(picture, CeilingRed), 0);
    EXPECT_LT(countPixels(picture, FloorBlue), 100) << "more blue than the marks of two scans";
    EXPECT_GT(countPixels(picture, WallYellow), 300);
    // A place on the floor, a metre beside the first scan: grey, and lighter than the background.
    const QRgb ground = picture.pixel(view.at({1.5, 1.2, -1.0}).toPoint());
    EXPECT_GT(qGray(ground), 140);
    EXPECT_LT(std::abs(qRed(ground) - qBlue(ground)), 40);
}

TEST(MapLooks, TopLookMarksWhereTheScansWereTaken) {
    ShownView view(room(), settingsOf(MapLook::Top));
    const QImage picture = view->picture();
    for (const MapScan& scan : room()->scans) {
        const QRgb mark = picture.pixel(view.at(scan.poseInMap.translation()).toPoint());
        EXPECT_GT(qBlue(mark), 150) << std::hex << mark;
        EXPECT_LT(qRed(mark), 110) << std::hex << mark;
    }
}

TEST(MapLooks, FacesOfAVoxelCanBeToldApart) {
    const MapPtr map = mapOf({blob({4.25F, 0.25F, 0.25F}, Label::Wall)});
    ShownView view(map, voxelsOf(0.5));
    const QImage picture = view->picture();
    const QPointF low = view.at({4, 0, 0}), high = view.at({4.5, 0.5, 0.5});
    EXPECT_GT(std::hypot(high.x() - low.x(), high.y() - low.y()), 5);
    std::set<QRgb> shades;
    for (const Eigen::Vector3d& face : {Eigen::Vector3d(4.25, 0.25, 0.5), Eigen::Vector3d(4.0, 0.25, 0.25),
                                        Eigen::Vector3d(4.25, 0.0, 0.25)}) {
        shades.insert(picture.pixel(view.at(face).toPoint()));
    }
    EXPECT_EQ(shades.size(), 3U);
    for (const QRgb shade : shades) EXPECT_GT(qRed(shade), 2 * qBlue(shade)) << "not a shade of yellow";
}

TEST(MapLooks, VoxelTakesTheLabelOfMostOfItsPoints) {
    const auto mixed = std::make_shared<Scan>(*blob({4.25F, 0.25F, 0.25F}, Label::Floor));
    std::fill_n(mixed->labels.begin(), mixed->labels.size() / 3, Label::Wall);
    ShownView view(mapOf({mixed}), voxelsOf(0.5));
    const QRgb top = view->picture().pixel(view.at({4.25, 0.25, 0.5}).toPoint());
    EXPECT_GT(qBlue(top), 2 * qRed(top));
}

TEST(MapLooks, AMapToWhichNothingComesIsGreyed) {
    ShownView view(mapOf({blob({4, 0, 0}, Label::Wall)}));
    const QPointF wall = view.at({4, 0, 0});
    const QRgb live = colourAt(view.onScreen(), wall, DarkBackground);
    view->setStale(true);
    const QImage stale = view.onScreen();
    EXPECT_LT(qRed(colourAt(stale, wall, DarkBackground)), 0.7 * qRed(live));
    EXPECT_EQ(stale.pixel(5, 5), DarkBackground);
    view->setStale(false);
    EXPECT_EQ(colourAt(view.onScreen(), wall, DarkBackground), live);
}

TEST(MapLooks, ColoursByScanDiffer) {
    ShownView view(mapOf({blob({4, 1, 0}, Label::Wall), blob({4, -1, 0}, Label::Wall)}),
                   settingsOf(MapLook::Points, MapColouring::Scan));
    const QImage picture = view->picture();
    const QRgb left = colourAt(picture, view.at({4, 1, 0}), DarkBackground);
    const QRgb right = colourAt(picture, view.at({4, -1, 0}), DarkBackground);
    EXPECT_NE(left, right);
    EXPECT_NE(left, DarkBackground);
    EXPECT_NE(right, DarkBackground);
}

/// Two blobs on the left and on the right, two minutes apart, of two robots, a dim and a bright one.
MapPtr twoRobots() {
    const auto made = [](float y, const char* robot, int minute, float intensity) {
        const auto scan = std::make_shared<Scan>(*blob({4, y, 0}, Label::Wall));
        scan->robot = robot;
        scan->end = Time(std::chrono::minutes(28'000'000 + minute));
        scan->intensities.assign(scan->points.size(), intensity);
        return scan;
    };
    return mapOf({made(1, "kurt3d", 0, 10.0F), made(-1, "crawler", 2, 200.0F)});
}

TEST(MapLooks, ColoursByRobotAreThoseOfTheTeam) {
    ShownView view(twoRobots(), settingsOf(MapLook::Points, MapColouring::Robot));
    std::vector<RobotMark> team(2);
    team[0].face = {QStringLiteral("kurt3d"), QStringLiteral("K"), QStringLiteral("Kurt3D"), 0};
    team[1].face = {QStringLiteral("crawler"), QStringLiteral("C"), QStringLiteral("Crawler"), 1};
    for (RobotMark& robot : team) robot.baseInMap = poseFrom({-3, 0, 0}, 0, 0, 0);
    for (const MapLook look : {MapLook::Points, MapLook::Voxels}) {
        view.alter([look](MapViewSettings& settings) { settings.look = look; });
        view->setRobots(team);
        ASSERT_TRUE(view.settle());
        const QImage picture = view->picture();
        const QColor left = colourAt(picture, view.at({4, 1, 0}), DarkBackground);
        const QColor right = colourAt(picture, view.at({4, -1, 0}), DarkBackground);
        const ThemeColours& colours = coloursOf(Theme::Dark);
        EXPECT_LT(std::abs(left.hue() - colours.robot(0).hue()), 12) << left.name().toStdString();
        EXPECT_LT(std::abs(right.hue() - colours.robot(1).hue()), 12) << right.name().toStdString();
    }
}

/// CIE 1976 L*a*b* of a colour (D65), in which distances are as people see them.
Eigen::Vector3d labOf(const QColor& colour) {
    const auto linear = [](double c) { return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92; };
    const double r = linear(colour.redF()), g = linear(colour.greenF()), b = linear(colour.blueF());
    const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = root((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047),
                 y = root(0.2126 * r + 0.7152 * g + 0.0722 * b),
                 z = root((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

TEST(MapLooks, EightRobotsAreToldApartByTheirColours) {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        const ThemeColours& colours = coloursOf(theme);
        for (int a = 0; a < 8; ++a) {
            for (int b = 0; b < a; ++b)
                EXPECT_GT((labOf(colours.robot(a)) - labOf(colours.robot(b))).norm(), 20.0) << a << " " << b;
        }
    }
}

TEST(MapLooks, ColoursByIntensityAndAgeGoFromDarkVioletToYellow) {
    for (const MapLook look : {MapLook::Points, MapLook::Voxels}) {
        ShownView view(twoRobots(), settingsOf(look, MapColouring::Intensity));
        for (const MapColouring colouring : {MapColouring::Intensity, MapColouring::Age}) {
            view.alter([colouring](MapViewSettings& settings) { settings.colouring = colouring; });
            const QImage picture = view->picture();
            const QRgb low = colourAt(picture, view.at({4, 1, 0}), DarkBackground);
            const QRgb high = colourAt(picture, view.at({4, -1, 0}), DarkBackground);
            EXPECT_GT(qGreen(high), qGreen(low) + 60);
            EXPECT_GT(qBlue(low), qBlue(high));
        }
    }
}

TEST(MapLooks, WithoutIntensitiesAndTimesThereIsStillAMap) {
    ShownView view(mapOf({blob({4, 1, 0}, Label::Wall), blob({4, -1, 0}, Label::Wall)}),
                   settingsOf(MapLook::Points, MapColouring::Intensity));
    const QRgb left = colourAt(view->picture(), view.at({4, 1, 0}), DarkBackground);
    EXPECT_LT(std::abs(qRed(left) - qBlue(left)), 40) << "grey: nobody told them";
    EXPECT_NE(left, DarkBackground);
    view.alter([](MapViewSettings& settings) { settings.colouring = MapColouring::Age; });
    const QImage picture = view->picture();
    EXPECT_GT(qGreen(colourAt(picture, view.at({4, -1, 0}), DarkBackground)),
              qGreen(colourAt(picture, view.at({4, 1, 0}), DarkBackground)) + 60)
        << "in their order";
}

TEST(MapLooks, ColoursByHeightAndRangeGoFromDarkVioletToYellow) {
    ShownView view(mapOf({blob({2, 0, -1}, Label::Wall), blob({8, 0, 3}, Label::Wall)}),
                   settingsOf(MapLook::Points, MapColouring::Height));
    for (const MapColouring colouring : {MapColouring::Height, MapColouring::Range}) {
        view.alter([colouring](MapViewSettings& settings) { settings.colouring = colouring; });
        const QImage picture = view->picture();
        const QRgb low = colourAt(picture, view.at({2, 0, -1}), DarkBackground);
        const QRgb high = colourAt(picture, view.at({8, 0, 3}), DarkBackground);
        EXPECT_GT(qGreen(high), qGreen(low) + 60);
        EXPECT_GT(qBlue(low), qBlue(high));
    }
}

TEST(MapLooks, ScansAreShownASecondTimeWhereTheyMightComeToStand) {
    constexpr QRgb Violet = 0xFFE2A6FF;
    for (const std::size_t scans : {2U, 60U}) {  // each drawn by itself, and of many a sample first
        std::vector<ScanPtr> blobs;
        for (std::size_t i = 0; i < scans; ++i)
            blobs.push_back(blob({2.0F + 0.02F * static_cast<float>(i), 0, 0}, Label::Wall));
        auto map = std::make_shared<Map>(*mapOf(blobs));
        for (std::size_t i = 0; i < scans; ++i) map->scans[i].id = i + 1;
        ShownView view(map, settingsOf(MapLook::Top));
        ASSERT_TRUE(view.settle());
        EXPECT_EQ(countPixels(view->picture(), Violet), 0);
        const QPointF before = view.at({2.0, 0.0, 0.0});
        view->setGhosts({{1, poseFrom({0.0, 0.4, 0.0}, 0, 0, 0)}, {4'711, Pose::Identity()}});
        ASSERT_TRUE(view.settle());
        const int ghost = countPixels(view->picture(), Violet);
        EXPECT_GT(ghost, 10) << scans;
        EXPECT_GT(countPixels(view->picture(), WallYellow), 10) << "the scan itself stays";
        EXPECT_EQ(view.at({2.0, 0.0, 0.0}), before) << "the camera does not move for it";
        EXPECT_FALSE(view->pick(view.at({2.0, 0.4, 0.0}).toPoint())) << "nothing is there yet";
        auto more = std::make_shared<Map>(*map);
        more->scans.push_back(more->scans.back());
        more->scans.back().id = scans + 1;
        view->setMap(more);
        ASSERT_TRUE(view.settle());
        EXPECT_NEAR(countPixels(view->picture(), Violet), ghost, ghost / 2 + 20) << "also once another came";
        view->setGhosts({});
        ASSERT_TRUE(view.settle());
        EXPECT_EQ(countPixels(view->picture(), Violet), 0);
    }
}

}  // namespace
}  // namespace leitstand::test
