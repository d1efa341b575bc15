#include <map>
#include <set>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/handin/file_names.h"
#include "core/handin/map/map_painter.h"
#include "tests/core/handin/report_scene.h"

namespace leitstand::test {
namespace {

/// 4 m x 4 m: free, but for a wall at x = 3, and unexplored where y is below -1.
MapDrawing drawing() {
    MapDrawing made;
    made.title = "RoboCup2013-Team-Mission.tif";
    OccupancyGrid& grid = made.grid;
    grid.origin = {0.0, -2.0};
    grid.columns = grid.rows = 80;
    grid.cells.resize(6400);
    for (int y = 20; y < 80; ++y) {
        for (int x = 0; x < 80; ++x) {
            auto& cell = grid.cells[static_cast<std::size_t>(80 * y + x)];
            cell.state = x == 60 ? OccupancyGrid::State::Occupied : OccupancyGrid::State::Free;
            cell.confidence = y < 40 ? 0.0F : 1.0F;
            if (y >= 70) cell.cleared = y >= 75 ? 1.0F : 0.0F;
        }
    }
    made.paths = {{{0.25, 0.25}, {2.25, 0.25}}};
    made.starts = {{{0.25, 0.25}, 0.0}};
    using Kind = MapMark::Kind;
    made.marks = {{Kind::Victim, 1, {2.25, -0.25}},
                  {Kind::UnconfirmedVictim, 2, {1.25, -0.25}},
                  {Kind::Hazard, 3, {2.25, 0.75}},
                  {Kind::Code, 4, {1.25, 0.75}},
                  {Kind::Object, 5, {0.25, 0.75}}};
    return made;
}

Rgb at(const MapPicture& map, double x, double y) {
    const Eigen::Vector2d pixel = map.pixelOf({x, y});
    return map.at(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
}

TEST(MapPainter, EveryElementHasTheColourOfTheRules) {
    const MapPicture map = paintMap(drawing());
    EXPECT_EQ(at(map, 0.26, -0.26), (Rgb{128, 128, 128})) << "explored, low confidence";
    EXPECT_EQ(at(map, 0.26, 1.26), (Rgb{255, 255, 255})) << "explored, high confidence";
    EXPECT_EQ(at(map, 0.26, 1.63), (Rgb{180, 230, 180})) << "cleared, low confidence";
    EXPECT_EQ(at(map, 0.26, 1.88), (Rgb{130, 230, 130})) << "cleared, high confidence";
    EXPECT_EQ(at(map, 3.02, 1.26), (Rgb{0, 40, 120})) << "wall";
    EXPECT_EQ(at(map, 0.5, -1.5), (Rgb{226, 226, 227})) << "unexplored";
    EXPECT_EQ(at(map, 1.5, -1.5), (Rgb{237, 237, 238})) << "unexplored, next square";
    EXPECT_EQ(at(map, 2.505, 1.3), (Rgb{190, 190, 191})) << "grid";
    EXPECT_EQ(at(map, 1.7, 0.25), (Rgb{120, 0, 140})) << "path";
    EXPECT_EQ(at(map, 0.4, 0.25), (Rgb{255, 200, 0})) << "start";
    EXPECT_EQ(at(map, 2.40, -0.25), (Rgb{240, 10, 10})) << "victim";
    EXPECT_EQ(at(map, 1.25, -0.25), (Rgb{240, 100, 10})) << "unconfirmed victim";
    EXPECT_EQ(at(map, 2.42, 0.75), (Rgb{255, 100, 30})) << "hazard";
    EXPECT_EQ(at(map, 1.25, 0.75), (Rgb{10, 10, 240})) << "QR code";
    EXPECT_EQ(at(map, 0.25, 0.75), (Rgb{10, 240, 10})) << "object of interest";
}

TEST(MapPainter, NothingElseIsInThePicture) {
    const MapPicture map = paintMap(drawing());
    using namespace map_colour;
    std::set<std::tuple<int, int, int>> allowed;
    for (const Rgb& colour :
         {Text, Scale, UnexploredLight, UnexploredDark, Grid, Wall, ExploredLeast, ExploredMost, ClearedLeast,
          ClearedMost, Victim, UnconfirmedVictim, Hazard, Code, Object, Start, Path, Number})
        allowed.emplace(colour.red, colour.green, colour.blue);
    std::map<std::tuple<int, int, int>, int> found;
    for (int row = 0; row < map.picture.height; ++row) {
        for (int column = 0; column < map.picture.width; ++column) {
            const Rgb colour = map.at(column, row);
            ++found[{colour.red, colour.green, colour.blue}];
        }
    }
    for (const auto& [colour, count] : found) EXPECT_TRUE(allowed.contains(colour)) << count;
    EXPECT_EQ(found.size(), allowed.size()) << "all are";
    // Sizes: numbers hide some of the discs.
    const auto area = [&](Rgb colour) {
        return found[{colour.red, colour.green, colour.blue}] * map.perPixel * map.perPixel;
    };
    EXPECT_NEAR(area(UnconfirmedVictim), 0.0962, 0.002) << "0.35 m across";
    EXPECT_NEAR(area(Code), 0.0962, 0.002);
    EXPECT_NEAR(area(Object), 0.09, 0.003) << "0.30 m a side";
    EXPECT_NEAR(area(Path), 0.02 * (2.0 - 0.3), 0.008) << "0.02 m wide";
    EXPECT_LT(area(Victim), 0.095) << "with a white number";
    EXPECT_GT(area(Victim), 0.07);
}

TEST(MapPainter, AVictimIsSeenWhereItsTagIsMarkedToo) {
    using Kind = MapMark::Kind;
    for (const auto& [under, name] : {std::pair(Kind::Code, "its tag"),
                                      {Kind::Object, "an object"},
                                      {Kind::Hazard, "a hazard"},
                                      {Kind::UnconfirmedVictim, "a guess"}}) {
        MapDrawing both = drawing();
        both.marks = {{Kind::Victim, 1, {1.25, 0.75}}, {under, 2, {1.25, 0.75}}};
        EXPECT_EQ(at(paintMap(both), 1.40, 0.75), map_colour::Victim) << name;
        std::swap(both.marks[0], both.marks[1]);
        EXPECT_EQ(at(paintMap(both), 1.40, 0.75), map_colour::Victim) << name;
    }
}

TEST(MapPainter, XIsUpAndYIsLeft) {
    const MapPicture map = paintMap(drawing());
    EXPECT_LT(map.pixelOf({2.0, 0.0}).y(), map.pixelOf({1.0, 0.0}).y());
    EXPECT_LT(map.pixelOf({0.0, 1.0}).x(), map.pixelOf({0.0, 0.0}).x());
    EXPECT_DOUBLE_EQ(map.perPixel, 0.01);
    EXPECT_DOUBLE_EQ(map.topLeft.y(), 3.0) << "a metre beyond the map, on a whole metre";
}

TEST(MapPainter, HugeMapsBecomeCoarserAndEmptyOnesASmallPicture) {
    MapDrawing far = drawing();
    far.paths.push_back({{0.0, 0.0}, {150.0, 90.0}});
    const MapPicture map = paintMap(far);
    EXPECT_GT(map.perPixel, 0.01);
    EXPECT_LE(static_cast<double>(map.picture.width) * map.picture.height, 45e6);
    far.marks.push_back({MapMark::Kind::Object, 9, {1e7, 1e7}});
    EXPECT_DOUBLE_EQ(paintMap(far).perPixel, map.perPixel) << "a mark a thousand kilometres off is left out";
    const MapPicture nothing = paintMap({});
    EXPECT_GT(nothing.picture.width, 100);
    MapDrawing broken;
    broken.paths = {{{std::nan(""), 0.0}, {1.0, 1.0}}};
    broken.marks = {{MapMark::Kind::Victim, 1, {std::nan(""), 0.0}}};
    EXPECT_GT(paintMap(broken).picture.width, 100);
}

TEST(MapPainter, APartOfTheMapIsPaintedWithoutTitle) {
    PaintSettings settings;
    settings.area = MapArea{{0.0, -1.0}, {3.0, 1.0}};
    settings.title = false;
    settings.perPixel = 0.02;
    const MapPicture map = paintMap(drawing(), settings);
    EXPECT_EQ(map.picture.width, 100);
    EXPECT_EQ(map.picture.height, 150);
    EXPECT_EQ(at(map, 1.25, 0.75), (Rgb{10, 10, 240}));
}

TEST(FileNames, TakeWhatEveryFileSystemTakes) {
    EXPECT_EQ(handInName("RoboCup2013", "Team", "Mission"), "RoboCup2013-Team-Mission");
    EXPECT_EQ(handInName("RoboCup German Open", "Rüttel & Söhne", "Lauf 3/b"),
              "RoboCup_German_Open-Ruettel_Soehne-Lauf_3_b");
    EXPECT_EQ(handInName("", "../../etc", "救助"), "Competition-etc-Mission");
    EXPECT_EQ(fileNamePart("a-b:c*d?e\"f<g>h|i\\j\nk"), "a_b_c_d_e_f_g_h_i_j_k");
    EXPECT_EQ(fileNamePart(".hidden."), "hidden");
    EXPECT_LE(fileNamePart(std::string(5000, 'x')).size(), 61u);
}

TEST(FileNames, NoTwoRobotsShareAFile) {
    const std::vector<std::string> robots = {"rover_1", "rover__1", "Rover 1", "救助", "robot", "rover_1_2"};
    EXPECT_EQ(fileNameParts(robots), (std::vector<std::string>{"rover_1", "rover_1_2", "Rover_1_3", "robot",
                                                               "robot_2", "rover_1_2_2"}));
    EXPECT_TRUE(fileNameParts({}).empty());
}

}  // namespace
}  // namespace leitstand::test
