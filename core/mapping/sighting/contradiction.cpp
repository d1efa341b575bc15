#include "core/mapping/sighting/contradiction.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapping/sighting/floor_field.h"

namespace leitstand {
namespace {

constexpr double Cell = 0.05, FloorCell = 0.1;  ///< [m]
constexpr double Itself = 0.35;                 ///< the map may hold the robot itself so near [m]
constexpr double Before = 0.25;     ///< a wall so near before a point is the one that was seen [m]
constexpr double Apart = 0.2;       ///< from walls; a place farther away is empty [m]
constexpr double FloorAbout = 0.1;  ///< up and down [m]
constexpr float Level = 0.9F;       ///< of a floor's normal, z

}  // namespace

double contradiction(const LaserView& view, const LocalMap& local, const WallMap& map, const FlatPose& pose) {
    double reach = 0.0;
    for (const Eigen::Vector2f& point : view.points) reach = std::max(reach, double{point.norm()});
    if (view.points.empty() || !map.search) return 0.0;
    const SquareGrid grid(pose.place, reach + Cell, Cell), floors(pose.place, reach + Cell, FloorCell);
    std::vector<char> walls(grid.cells(), 0), open(floors.cells(), 0);
    for (const Eigen::Vector3f& wall : map.walls.points) {
        if (const auto cell = grid.cellOf(wall.head<2>().cast<double>())) walls[*cell] = 1;
    }
    for (std::size_t i = 0; i < local.cloud.size() && i < local.cloud.normals.size(); ++i) {
        const Eigen::Vector3f& point = local.cloud.points[i];
        const bool floor = std::abs(local.cloud.normals[i].z()) > Level &&
                           std::abs(double{point.z()} - map.ground) < FloorAbout;
        const auto cell = floor ? floors.cellOf(point.head<2>().cast<double>()) : std::nullopt;
        if (cell) open[*cell] = 1;
    }
    const auto against = [&](const Eigen::Vector2f& point) {
        const double range = double{point.norm()};
        const Eigen::Vector2d along = point.cast<double>().normalized();
        for (double way = Itself; way < range - Before; way += 0.5 * Cell) {
            const auto cell = grid.cellOf(pose * (way * along));
            if (cell && walls[*cell] != 0) return true;
        }
        const Eigen::Vector2d place = pose * point.cast<double>();
        const auto cell = floors.cellOf(place);
        if (!cell || open[*cell] == 0) return false;
        const Eigen::Vector3f flat(static_cast<float>(place.x()), static_cast<float>(place.y()), 0.0F);
        return !map.search->nearest(flat, Label::Unlabelled, static_cast<float>(Apart * Apart)).found();
    };
    return static_cast<double>(std::count_if(view.points.begin(), view.points.end(), against)) /
           static_cast<double>(view.points.size());
}

}  // namespace leitstand
