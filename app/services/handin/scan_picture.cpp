#include "app/services/handin/scan_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/handin/map/map_canvas.h"

namespace leitstand {
namespace {

constexpr int Side = 560;                       ///< of the picture [px]
constexpr double LeastHalf = 2.5;               ///< half the shown area's side, at least [m]
constexpr double MostHalf = 6.0;                ///< at most; a robot farther off is not in it [m]
constexpr double Lowest = -0.2, Highest = 1.8;  ///< of the colours, above the robot's base [m]
constexpr Rgb Paper{255, 255, 255}, Line{225, 225, 225}, Bar{0, 0, 0};
constexpr Rgb FindColour{0xD5, 0x5E, 0x00}, RobotColour{0, 0, 0};

/// viridis in steps of a quarter.
constexpr std::array<Rgb, 5> Viridis = {
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

Rgb colourOf(double height) {
    const double place = 4.0 * std::clamp((height - Lowest) / (Highest - Lowest), 0.0, 1.0);
    const auto step = std::min<std::size_t>(3, static_cast<std::size_t>(place));
    const double share = place - static_cast<double>(step);
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + share * (b - a)));
    };
    const Rgb low = Viridis[step], high = Viridis[step + 1];
    return {mix(low.red, high.red), mix(low.green, high.green), mix(low.blue, high.blue)};
}

MapPicture blank(const Eigen::Vector2d& middle, double half) {
    MapPicture map;
    map.perPixel = 2.0 * half / Side;
    map.topLeft = middle + Eigen::Vector2d(half, half);
    map.picture = {.width = Side, .height = Side, .pixel = Picture::Pixel::Rgb8, .bytes = {}};
    map.picture.bytes.resize(3U * Side * Side);
    return map;
}

void paintPaper(MapCanvas& canvas) {
    const double step = canvas.map().perPixel;
    const auto crosses = [&](double from) { return std::floor(from) != std::floor(from - step); };
    for (int row = 0; row < Side; ++row) {
        const bool across = crosses(canvas.map().topLeft.x() - row * step);
        for (int column = 0; column < Side; ++column) {
            const bool along = crosses(canvas.map().topLeft.y() - column * step);
            canvas.set(column, row, across || along ? Line : Paper);
        }
    }
}

void paintRobot(MapCanvas& canvas, const Pose& baseInMap) {
    const Eigen::Vector2d place = baseInMap.translation().head<2>();
    const Eigen::Vector2d along = baseInMap.linear().col(0).head<2>().normalized();
    const Eigen::Vector2d side(-along.y(), along.x());
    canvas.polygon({place + 0.3 * along, place - 0.3 * along + 0.2 * side, place - 0.15 * along,
                    place - 0.3 * along - 0.2 * side},
                   RobotColour);
}

}  // namespace

MapPicture scanPicture(const std::vector<Eigen::Vector3d>& points, const ScanPictureMarks& marks) {
    const Eigen::Vector3d robot =
        marks.baseInMap ? Eigen::Vector3d(marks.baseInMap->translation()) : Eigen::Vector3d::Zero();
    const Eigen::Vector3d middle = marks.find.value_or(robot);
    double half = LeastHalf;
    if (marks.baseInMap) half = std::max(half, (robot - middle).head<2>().cwiseAbs().maxCoeff() + 0.5);
    MapCanvas canvas(blank(middle.head<2>(), std::min(half, MostHalf)));
    paintPaper(canvas);
    // High points over low ones, as from above.
    std::vector<const Eigen::Vector3d*> rising;
    for (const Eigen::Vector3d& point : points) {
        if (point.allFinite() && (point - middle).head<2>().cwiseAbs().maxCoeff() < half)
            rising.push_back(&point);
    }
    std::stable_sort(rising.begin(), rising.end(),
                     [](const auto* a, const auto* b) { return a->z() < b->z(); });
    for (const Eigen::Vector3d* point : rising) {
        const Eigen::Vector2d pixel = canvas.map().pixelOf(point->head<2>());
        const int column = static_cast<int>(pixel.x()), row = static_cast<int>(pixel.y());
        const Rgb colour = colourOf(point->z() - robot.z());
        for (const int right : {0, 1}) {
            for (const int down : {0, 1}) canvas.set(column + right, row + down, colour);
        }
    }
    if (marks.baseInMap) paintRobot(canvas, *marks.baseInMap);
    if (marks.find) {
        canvas.disc(marks.find->head<2>(), 0.26, Paper);
        canvas.disc(marks.find->head<2>(), 0.20, FindColour);
    }
    const Eigen::Vector2d corner = canvas.map().topLeft;
    const double low = corner.x() - Side * canvas.map().perPixel;
    canvas.bar({low + 0.22, corner.y() - 0.2}, 1.0, 0.05, Bar);
    canvas.text({low + 0.30, corner.y() - 0.2}, "1 m", 0.14, Bar);
    return std::move(canvas).take();
}

}  // namespace leitstand
