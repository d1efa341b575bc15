#include "robots/simulation/stock/stock_localisation.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/event/stream_role.h"
#include "robots/simulation/arena/arena.h"
#include "robots/simulation/scene/scene.h"

namespace leitstand::simulation {
namespace {

constexpr double Cell = 0.05;        // [m]
constexpr double Margin = 0.5;       // around the arena [m]
constexpr double LaserHeight = 0.2;  // above the arena's floor [m]
constexpr auto GridPeriod = std::chrono::seconds(5);
constexpr auto TransformPeriod = std::chrono::milliseconds(50);

}  // namespace

Pose StockLocalisation::mapInArena() {
    Pose pose(Eigen::AngleAxisd(degrees(30.0), Eigen::Vector3d::UnitZ()));
    pose.translation() = Eigen::Vector3d(1.5, -2.0, 0.0);
    return pose;
}

StockLocalisation::StockLocalisation(const World& world, int robot, const RobotDescription& description)
    : m_robot(robot), m_frame(description.odomFrame.substr(0, description.odomFrame.rfind('/') + 1) + "map") {
    if (description.stream(StreamRole::Grid) != nullptr) m_grid = gridOf(world);
}

OccupancyGridSample StockLocalisation::gridOf(const World& world) const {
    const Arena& arena = world.arena();
    const Eigen::Vector2d low = arena.from - Eigen::Vector2d::Constant(Margin);
    const Eigen::Vector2d size = arena.to - arena.from + Eigen::Vector2d::Constant(2 * Margin);
    OccupancyGridSample grid;
    grid.header.frame = m_frame;
    grid.resolution = Cell;
    grid.width = static_cast<int>(std::ceil(size.x() / Cell));
    grid.height = static_cast<int>(std::ceil(size.y() / Cell));
    Pose gridInArena = Pose::Identity();
    gridInArena.translation().head<2>() = low;
    grid.gridInFrame = mapInArena().inverse() * gridInArena;
    grid.cells.resize(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
    std::size_t at = 0;
    for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
            const Eigen::Vector3f corner(static_cast<float>(low.x() + Cell * column),
                                         static_cast<float>(low.y() + Cell * row),
                                         static_cast<float>(LaserHeight));
            // A surface through the cell crosses one of its middle lines.
            const float half = static_cast<float>(Cell) / 2.0F;
            const std::array<Ray, 2> rays = {
                Ray{corner + Eigen::Vector3f(0, half, 0), Eigen::Vector3f::UnitX(), 0.0F, 2 * half},
                Ray{corner + Eigen::Vector3f(half, 0, 0), Eigen::Vector3f::UnitY(), 0.0F, 2 * half}};
            const bool hit = std::any_of(rays.begin(), rays.end(), [&](const Ray& ray) {
                return world.scene().cast(ray, RayKind::Laser, Scene::StillOnly).there();
            });
            grid.cells[at++] = hit ? OccupancyGridSample::Occupied : std::int8_t{0};
        }
    }
    return grid;
}

std::vector<HardwareSample> StockLocalisation::step(const World& world,
                                                    const std::vector<HardwareSample>& sent) {
    std::vector<HardwareSample> due;
    if (!m_grid) return due;
    const Time now = world.now();
    if (now >= m_gridDue) {
        m_gridDue = now + GridPeriod;
        m_grid->header.stamp = now;
        due.push_back({.role = StreamRole::Grid, .sensor = {}, .sample = *m_grid});
    }
    if (now < m_transformDue) return due;
    for (const HardwareSample& one : sent) {
        const auto* odometry = one.sample.as<OdometrySample>();
        if (odometry == nullptr) continue;
        m_transformDue = now + TransformPeriod;
        const Pose truth = world.baseInArena(m_robot, odometry->header.stamp);
        const Pose odomInMap = mapInArena().inverse() * truth * odometry->baseInOdom.inverse();
        due.push_back({.role = StreamRole::Transforms,
                       .sensor = {},
                       .sample = TransformsSample{
                           {{{odometry->header.stamp, m_frame}, odometry->header.frame, odomInMap}}}});
        break;
    }
    return due;
}

}  // namespace leitstand::simulation
