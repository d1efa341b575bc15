#include "core/handin/map/map_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "core/handin/map/map_canvas.h"

namespace leitstand {
namespace {

constexpr double Above = 2.0;         ///< of the map's own area, for the title [m]
constexpr double TextHeight = 0.30;   ///< of a capital letter [m]
constexpr double ScaleHeight = 0.22;  ///< of the letters at the scale bar [m]
constexpr double Inset = 0.30;        ///< of title and scale from the corner [m]

Rgb between(Rgb least, Rgb most, float share) {
    const auto mix = [share](int a, int b) {
        return static_cast<std::uint8_t>(
            std::lround(static_cast<float>(a) + share * static_cast<float>(b - a)));
    };
    return {mix(least.red, most.red), mix(least.green, most.green), mix(least.blue, most.blue)};
}

Rgb checker(double x, double y) {
    const double sum = std::floor(x / map_size::Checker) + std::floor(y / map_size::Checker);
    return std::fmod(std::abs(sum), 2.0) < 0.5 ? map_colour::UnexploredLight : map_colour::UnexploredDark;
}

/// Whether a pixel that begins at @p low and is @p perPixel wide contains a line of the grid.
bool onGrid(double low, double perPixel) {
    const double line = std::ceil(low / map_size::Grid - 1e-6) * map_size::Grid;
    return line - low < perPixel - 1e-9;
}

/// Returns what @p grid shows in a pixel around its middle. Of several cells it takes an occupied one,
/// otherwise an explored one, so that walls do not vanish between the middles of pixels.
OccupancyGrid::Cell cellIn(const OccupancyGrid& grid, double x, double y, double perPixel) {
    OccupancyGrid::Cell shown = grid.at(x, y);
    const int across = static_cast<int>(std::lround(perPixel / grid.cell));
    if (across < 2) return shown;
    for (int i = 0; i < across * across && shown.state != OccupancyGrid::State::Occupied; ++i) {
        const double u = (i % across + 0.5) / across - 0.5, v = (i / across + 0.5) / across - 0.5;
        const OccupancyGrid::Cell cell = grid.at(x + u * perPixel, y + v * perPixel);
        const bool more =
            cell.state == OccupancyGrid::State::Occupied || shown.state == OccupancyGrid::State::Unexplored;
        if (more) shown = cell;
    }
    return shown;
}

/// Returns the colour of one pixel: unexplored, explored, grid, cleared or wall.
Rgb groundColour(const OccupancyGrid& grid, double x, double y, double perPixel) {
    const OccupancyGrid::Cell cell = cellIn(grid, x, y, perPixel);
    const auto sure = [](float value) { return std::clamp(value, 0.0F, 1.0F); };
    switch (cell.state) {
        case OccupancyGrid::State::Unexplored:
            break;
        case OccupancyGrid::State::Occupied:
            return map_colour::Wall;
        case OccupancyGrid::State::Free:
            if (cell.cleared >= 0.0F)
                return between(map_colour::ClearedLeast, map_colour::ClearedMost, sure(cell.cleared));
            if (onGrid(x - perPixel / 2, perPixel) || onGrid(y - perPixel / 2, perPixel))
                return map_colour::Grid;
            return between(map_colour::ExploredLeast, map_colour::ExploredMost, sure(cell.confidence));
    }
    return checker(x, y);
}

void paintGround(MapCanvas& canvas, const OccupancyGrid& grid) {
    const double step = canvas.map().perPixel;
    for (int row = 0; row < canvas.map().picture.height; ++row) {
        const double x = canvas.map().topLeft.x() - (row + 0.5) * step;
        for (int column = 0; column < canvas.map().picture.width; ++column) {
            const double y = canvas.map().topLeft.y() - (column + 0.5) * step;
            canvas.set(column, row, groundColour(grid, x, y, step));
        }
    }
}

void paintMark(MapCanvas& canvas, const MapMark& mark) {
    const auto numbered = [&](double height) {
        canvas.centredText(mark.place, std::to_string(mark.number), height, map_colour::Number);
    };
    switch (mark.kind) {
        case MapMark::Kind::Victim:
            canvas.disc(mark.place, map_size::Disc, map_colour::Victim);
            return numbered(mark.number < 100 ? 0.16 : 0.11);
        case MapMark::Kind::UnconfirmedVictim:
            canvas.disc(mark.place, map_size::Disc, map_colour::UnconfirmedVictim);
            return;
        case MapMark::Kind::Hazard:
            canvas.diamond(mark.place, map_size::Diamond, map_colour::Hazard);
            return numbered(mark.number < 10 ? 0.16 : 0.11);
        case MapMark::Kind::Code:
            canvas.disc(mark.place, map_size::Disc, map_colour::Code);
            return;
        case MapMark::Kind::Object:
            canvas.diamond(mark.place, map_size::Diamond, map_colour::Object);
            return;
    }
}

/// Paints the name beside marks that have no number by the rules, as text.
void paintName(MapCanvas& canvas, const MapMark& mark) {
    if (mark.kind == MapMark::Kind::Victim || mark.kind == MapMark::Kind::Hazard) return;
    const Eigen::Vector2d beside = mark.place + Eigen::Vector2d(-0.08, -0.26);
    canvas.text(beside, nameOf(mark), 0.16, map_colour::Text);
}

/// Paints the most important mark on top where marks overlap, such as a victim and its tag. Names are painted
/// over all of them.
void paintMarks(MapCanvas& canvas, std::vector<MapMark> marks, bool names) {
    std::stable_sort(marks.begin(), marks.end(),
                     [](const MapMark& a, const MapMark& b) { return a.kind > b.kind; });
    for (const MapMark& mark : marks) paintMark(canvas, mark);
    if (!names) return;
    for (const MapMark& mark : marks) paintName(canvas, mark);
}

/// Paints a bar of a metre, and the directions of x and y: up and to the left.
void paintScale(MapCanvas& canvas, const Eigen::Vector2d& topLeft) {
    const double wide = 0.04, tip = 0.12;
    const Rgb colour = map_colour::Scale;
    const Eigen::Vector2d corner = topLeft + Eigen::Vector2d(-1.55, -Inset - 0.9);
    // x upwards and y to the left, from their common corner; y's arrow is left of it.
    const auto arrow = [&](const Eigen::Vector2d& along) {
        const Eigen::Vector2d end = corner + 0.7 * along, side(-along.y(), along.x());
        canvas.line(corner, end - tip * along, wide, colour);
        canvas.polygon({end, end - tip * along + 0.07 * side, end - tip * along - 0.07 * side}, colour);
    };
    arrow({1.0, 0.0}), arrow({0.0, 1.0});
    canvas.text(corner + Eigen::Vector2d(0.50, -0.12), "x", ScaleHeight, colour);
    canvas.text(corner + Eigen::Vector2d(0.12, 0.68), "y", ScaleHeight, colour);
    const Eigen::Vector2d begin = corner + Eigen::Vector2d(0.0, -0.6),
                          end = begin + Eigen::Vector2d(0.0, -1.0);
    canvas.bar(begin, map_size::ScaleBar, wide, colour);
    canvas.bar(begin + Eigen::Vector2d(0.06, 0.0), wide, 0.16, colour);
    canvas.bar(end + Eigen::Vector2d(0.06, wide), wide, 0.16, colour);
    canvas.text(begin + Eigen::Vector2d(0.14, -0.33), "1 m", ScaleHeight, colour);
}

double textWidth(const std::string& text, double perPixel) {
    return MapCanvas::textWidth(text, TextHeight, perPixel);
}

MapPicture blank(const MapArea& area, double perPixel) {
    MapPicture map;
    map.perPixel = perPixel;
    map.topLeft = area.high;
    const Eigen::Vector2d size = (area.high - area.low) / perPixel;
    map.picture.width = std::max(1, static_cast<int>(std::lround(size.y())));
    map.picture.height = std::max(1, static_cast<int>(std::lround(size.x())));
    map.picture.pixel = Picture::Pixel::Rgb8;
    map.picture.bytes.resize(3U * static_cast<std::size_t>(map.picture.width) *
                             static_cast<std::size_t>(map.picture.height));
    return map;
}

/// Returns the finest resolution at which @p area has at most @p mostPixels. At each of them, cells of 5 cm,
/// 10 cm and so on are whole pixels or pixels are whole cells. The same holds for 0.5 m of the grid and for 1
/// m.
double resolutionFor(const MapArea& area, double mostPixels) {
    const double square = (area.high - area.low).prod();
    for (const double step : {0.01, 0.025, 0.05, 0.1, 0.25, 0.5}) {
        if (square / (step * step) <= mostPixels) return step;
    }
    return std::ceil(std::sqrt(square / mostPixels));
}

}  // namespace

std::string nameOf(const MapMark& mark) {
    switch (mark.kind) {
        case MapMark::Kind::Hazard:
            return fmt::format("H{}", mark.number);
        case MapMark::Kind::Code:
            return fmt::format("Q{}", mark.number);
        case MapMark::Kind::Object:
            return fmt::format("O{}", mark.number);
        case MapMark::Kind::Victim:
        case MapMark::Kind::UnconfirmedVictim:
            break;
    }
    return fmt::format("V{}", mark.number);
}

MapArea areaOf(const MapDrawing& drawing) {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    const auto take = [&](const Eigen::Vector2d& point) {
        if (!point.allFinite()) return;
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    };
    const OccupancyGrid& grid = drawing.grid;
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns; ++x) {
            const auto& cell =
                grid.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) +
                           static_cast<std::size_t>(x)];
            if (cell.state != OccupancyGrid::State::Unexplored)
                take(grid.origin + grid.cell * Eigen::Vector2d(x + 0.5, y + 0.5));
        }
    }
    for (const auto& path : drawing.paths) std::for_each(path.begin(), path.end(), take);
    for (const MapStart& start : drawing.starts) take(start.place);
    for (const MapMark& mark : drawing.marks) {
        // A mark a kilometre off would shrink the map to a point.
        if (low.x() <= high.x() &&
            ((mark.place - low).minCoeff() < -100.0 || (mark.place - high).maxCoeff() > 100.0))
            continue;
        take(mark.place);
    }
    if (!(low.x() <= high.x())) return {Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, 1.0)};
    return {low.array().floor() - 1.0, high.array().ceil() + 1.0};
}

MapPicture paintMap(const MapDrawing& drawing, const PaintSettings& settings) {
    MapArea area = settings.area.value_or(areaOf(drawing));
    double perPixel = settings.perPixel > 0.0 ? settings.perPixel : resolutionFor(area, settings.mostPixels);
    if (settings.title && !settings.area) {
        area.high.x() += Above;
        const double wide = std::ceil(std::max(3.0, textWidth(drawing.title, perPixel)) + 2 * Inset);
        area.low.y() = std::min(area.low.y(), area.high.y() - wide);
        if (settings.perPixel <= 0.0) perPixel = resolutionFor(area, settings.mostPixels);
    }
    MapCanvas canvas(blank(area, perPixel));
    paintGround(canvas, drawing.grid);
    for (const auto& path : drawing.paths) canvas.polyline(path, map_size::Path, map_colour::Path);
    for (const MapStart& start : drawing.starts) {
        const Eigen::Vector2d along(std::cos(start.heading), std::sin(start.heading)),
            side(-along.y(), along.x());
        const double half = map_size::Arrow / 2;
        canvas.polygon({start.place + half * along, start.place - half * along + 0.6 * half * side,
                        start.place - 0.5 * half * along, start.place - half * along - 0.6 * half * side},
                       map_colour::Start);
    }
    paintMarks(canvas, drawing.marks, settings.names);
    if (settings.title) {
        const Eigen::Vector2d corner = canvas.map().topLeft;
        canvas.text(corner - Eigen::Vector2d(Inset + TextHeight, Inset), drawing.title, TextHeight,
                    map_colour::Text);
        paintScale(canvas, corner);
    }
    return std::move(canvas).take();
}

}  // namespace leitstand
