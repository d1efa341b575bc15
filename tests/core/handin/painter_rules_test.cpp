// Sizes, places and layers of the hand-in map, pixel by pixel.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "core/handin/map/map_painter.h"

namespace leitstand::test {
namespace {

using Kind = MapMark::Kind;
using State = OccupancyGrid::State;

/// 6 m x 6 m from the origin on, all of one state.
MapDrawing floorOf(State state) {
    MapDrawing made;
    made.title = "A-B-C.tif";
    made.grid.origin = {0.0, 0.0};
    made.grid.columns = made.grid.rows = 120;
    made.grid.cells.resize(14'400);
    for (auto& cell : made.grid.cells) {
        cell.state = state;
        cell.confidence = 1.0F;
    }
    return made;
}

MapPicture untitled(const MapDrawing& drawing) {
    PaintSettings settings;
    settings.area = MapArea{{0.0, 0.0}, {6.0, 6.0}};
    settings.title = false;
    return paintMap(drawing, settings);
}

Rgb at(const MapPicture& map, double x, double y) {
    const Eigen::Vector2d pixel = map.pixelOf({x, y});
    return map.at(static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y())));
}

/// The pixels of a colour: how many, and the rectangle around them.
struct Spot {
    int count = 0, left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;
    [[nodiscard]] int width() const { return right - left + 1; }
    [[nodiscard]] int height() const { return bottom - top + 1; }
};
Spot spotOf(const MapPicture& map, Rgb colour) {
    Spot spot;
    for (int row = 0; row < map.picture.height; ++row) {
        for (int column = 0; column < map.picture.width; ++column) {
            if (map.at(column, row) != colour) continue;
            ++spot.count;
            spot.left = std::min(spot.left, column);
            spot.right = std::max(spot.right, column);
            spot.top = std::min(spot.top, row);
            spot.bottom = std::max(spot.bottom, row);
        }
    }
    return spot;
}

/// The longest row of neighbouring pixels of a colour.
int longestRun(const MapPicture& map, Rgb colour) {
    int longest = 0;
    for (int row = 0; row < map.picture.height; ++row) {
        int run = 0;
        for (int column = 0; column < map.picture.width; ++column) {
            run = map.at(column, row) == colour ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    return longest;
}

TEST(MapRules, TheScaleBarIsAMetreLong) {
    EXPECT_EQ(longestRun(paintMap(floorOf(State::Free)), map_colour::Scale), 100) << "pixels of a centimetre";
    PaintSettings coarse;
    coarse.perPixel = 0.05;
    EXPECT_EQ(longestRun(paintMap(floorOf(State::Free), coarse), map_colour::Scale), 20);
}

TEST(MapRules, TheTitleIsAtTheTopLeftAndHidesNothingOfTheMap) {
    const MapPicture map = paintMap(floorOf(State::Free));
    const Spot title = spotOf(map, map_colour::Text);
    ASSERT_GT(title.count, 100);
    EXPECT_LT(title.left, 50) << "half a metre from the left";
    EXPECT_LT(title.top, 50) << "and from the top";
    EXPECT_LT(title.bottom, 100) << "a line high";
    EXPECT_LT(spotOf(map, map_colour::Scale).bottom, static_cast<int>(map.pixelOf({6.0, 0.0}).y()))
        << "all of it is above the map's own area";
}

TEST(MapRules, UnexploredSquaresAlternateAllOverThePicture) {
    PaintSettings settings;
    settings.area = MapArea{{-2.5, -3.5}, {2.5, 1.5}};
    settings.title = false;
    const MapPicture map = paintMap(floorOf(State::Unexplored), settings);
    ASSERT_EQ(map.picture.width, 500);
    for (int row = 0; row < map.picture.height; ++row) {
        for (int column = 0; column < map.picture.width; ++column) {
            const double x = map.topLeft.x() - (row + 0.5) * map.perPixel,
                         y = map.topLeft.y() - (column + 0.5) * map.perPixel;
            const bool odd = (static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y))) % 2 != 0;
            ASSERT_EQ(map.at(column, row), odd ? map_colour::UnexploredDark : map_colour::UnexploredLight)
                << x << " " << y;
        }
    }
}

TEST(MapRules, TheGridIsAPixelWideEveryHalfMetreAllOverTheFloor) {
    const MapPicture map = untitled(floorOf(State::Free));
    ASSERT_EQ(map.picture.width, 600);
    ASSERT_EQ(map.picture.height, 600);
    // A line every 50 pixels, always in the same one of them.
    std::vector<int> across, along;
    for (int i = 0; i < 600; ++i) {
        if (map.at(i, 25) == map_colour::Grid) along.push_back(i);
        if (map.at(25, i) == map_colour::Grid) across.push_back(i);
    }
    for (const auto& lines : {across, along}) {
        ASSERT_EQ(lines.size(), 12U);
        for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_EQ(lines[i] - lines[i - 1], 50);
    }
    const auto has = [](const std::vector<int>& lines, int one) {
        return std::find(lines.begin(), lines.end(), one) != lines.end();
    };
    for (int row = 0; row < 600; ++row) {
        for (int column = 0; column < 600; ++column)
            ASSERT_EQ(map.at(column, row) == map_colour::Grid, has(across, row) || has(along, column))
                << column << " " << row;
    }
}

TEST(MapRules, AWallOfOneCellStaysInAPictureOfCoarserPixels) {
    for (const int column : {60, 61}) {
        MapDrawing drawing = floorOf(State::Free);
        for (int row = 0; row < 120; ++row)
            drawing.grid.cells[static_cast<std::size_t>(120 * row + column)].state = State::Occupied;
        PaintSettings settings;
        settings.area = MapArea{{0.0, 0.0}, {6.0, 6.0}};
        settings.title = false;
        settings.perPixel = 0.1;
        EXPECT_EQ(longestRun(paintMap(drawing, settings), map_colour::Wall), 60) << "cell " << column;
    }
}

TEST(MapRules, HoweverLargeTheMapACellIsAsManyPixelsAsAnother) {
    MapDrawing drawing = floorOf(State::Free);
    for (std::size_t i = 0; i < drawing.grid.cells.size(); i += 2)
        drawing.grid.cells[i].state = State::Occupied;  // stripes of a cell, 120 cells a row
    for (const double most : {36e6, 250e3, 60e3}) {
        PaintSettings settings;
        settings.area = MapArea{{0.0, 0.0}, {6.0, 6.0}};
        settings.title = false;
        settings.mostPixels = most;
        const MapPicture map = paintMap(drawing, settings);
        EXPECT_LE(map.picture.width * map.picture.height, most);
        std::size_t walls = 0;
        for (int row = 0; row < map.picture.height; ++row)
            walls += map.at(3, row) == map_colour::Wall ? 1 : 0;
        EXPECT_EQ(2 * walls, static_cast<std::size_t>(map.picture.height)) << map.perPixel << " m";
    }
}

TEST(MapRules, AHazardHasItsSizeAndItsNumberInWhite) {
    MapDrawing drawing = floorOf(State::Occupied);  // nothing white but the number
    drawing.marks = {{Kind::Hazard, 7, {3.0, 3.0}}};
    const MapPicture map = untitled(drawing);
    const Spot hazard = spotOf(map, map_colour::Hazard), number = spotOf(map, map_colour::Number);
    const double across = 100.0 * map_size::Diamond * std::sqrt(2.0);
    EXPECT_NEAR(hazard.width(), across, 2.0);
    EXPECT_NEAR(hazard.height(), across, 2.0);
    EXPECT_NEAR(hazard.count + number.count, 900.0, 30.0) << "0.30 m a side";
    ASSERT_GT(number.count, 10);
    EXPECT_NEAR(0.5 * (number.left + number.right), 300.0, 4.0) << "in its middle";
    EXPECT_NEAR(0.5 * (number.top + number.bottom), 300.0, 4.0);
    drawing.marks[0].number = 3;
    const MapPicture other = untitled(drawing);
    int different = 0;
    for (int i = 0; i < 360'000; ++i)
        different += other.at(i % 600, i / 600) == map.at(i % 600, i / 600) ? 0 : 1;
    EXPECT_GT(different, 5) << "another number is another picture";
}

TEST(MapRules, TheStartArrowPointsWhereTheRobotLooked) {
    for (const double turned : {0.0, 90.0, 180.0, -90.0, 37.0}) {
        MapDrawing drawing = floorOf(State::Free);
        drawing.starts = {{{3.0, 3.0}, degrees(turned)}};
        const MapPicture map = untitled(drawing);
        const Eigen::Vector2d along(std::cos(degrees(turned)), std::sin(degrees(turned)));
        const auto colour = [&](double ahead) {
            const Eigen::Vector2d place = Eigen::Vector2d(3.0, 3.0) + ahead * along;
            return at(map, place.x(), place.y());
        };
        EXPECT_EQ(colour(0.20), map_colour::Start) << turned;
        EXPECT_EQ(colour(0.0), map_colour::Start) << turned;
        EXPECT_NE(colour(0.33), map_colour::Start) << turned << ": its tip is at 0.30 m";
        EXPECT_NE(colour(-0.25), map_colour::Start) << turned << ": it is notched behind";
    }
}

TEST(MapRules, WhatMattersMoreLiesOverWhatMattersLess) {
    MapDrawing drawing = floorOf(State::Free);
    const auto cells = [&](double low, double high, auto change) {
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 120; ++x) {
                const double at = 0.05 * x;
                if (at >= low && at < high) change(drawing.grid.cells[static_cast<std::size_t>(120 * y + x)]);
            }
        }
    };
    cells(2.0, 3.0, [](auto& cell) { cell.cleared = 1.0F; });
    cells(3.0, 4.0, [](auto& cell) { cell.state = State::Occupied; });
    cells(4.0, 5.0, [](auto& cell) {
        cell.state = State::Occupied;
        cell.cleared = 1.0F;
    });
    drawing.paths = {{{0.2, 2.25}, {5.8, 2.25}}};
    drawing.starts = {{{0.3, 2.25}, 0.0}};
    drawing.marks = {{Kind::Victim, 1, {3.3, 2.25}}, {Kind::Object, 2, {5.7, 2.25}}};
    const MapPicture map = untitled(drawing);
    EXPECT_EQ(at(map, 1.505, 4.26), map_colour::Grid) << "the grid over the explored floor";
    EXPECT_EQ(at(map, 2.505, 4.26), map_colour::ClearedMost) << "cleared over the grid";
    EXPECT_EQ(at(map, 3.505, 4.26), map_colour::Wall) << "walls over the grid";
    EXPECT_EQ(at(map, 4.26, 4.26), map_colour::Wall) << "and over cleared";
    for (const double x : {1.2, 2.4, 3.7, 4.4})
        EXPECT_EQ(at(map, x, 2.25), map_colour::Path) << "paths over all of them, at " << x;
    EXPECT_EQ(at(map, 0.45, 2.25), map_colour::Start) << "marks over the paths";
    EXPECT_EQ(at(map, 3.44, 2.25), map_colour::Victim);
    EXPECT_EQ(at(map, 5.7, 2.25), map_colour::Object);
    int white = 0;
    for (double away = -0.08; away < 0.08; away += 0.005)
        white += at(map, 3.3 + away, 2.25) == map_colour::Number ? 1 : 0;
    EXPECT_GT(white, 5) << "and their numbers over the marks";
}

// The tag of a victim hangs beside it.
TEST(MapRules, NamesAreNotHiddenByTheirNeighbours) {
    MapDrawing drawing = floorOf(State::Free);
    drawing.marks = {{Kind::Code, 1, {3.0, 3.0}}};
    const int alone = spotOf(untitled(drawing), map_colour::Text).count;
    ASSERT_GT(alone, 20);
    drawing.marks.push_back({Kind::Victim, 1, {3.0, 2.65}});
    EXPECT_EQ(spotOf(untitled(drawing), map_colour::Text).count, alone);
}

}  // namespace
}  // namespace leitstand::test
