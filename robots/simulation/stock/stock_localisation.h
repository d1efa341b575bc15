#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/robot/robot_description.h"
#include "robots/hardware/robot_hardware.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// Stands for the map_server and the localisation of a stock robot, without errors. The first is a grid map
/// of the arena as its laser would see it, the second the transform from that map to the odometry. The map
/// was made on another day: it neither begins at the robot's start nor lies along the arena.
class StockLocalisation {
public:
    StockLocalisation(const World& world, int robot, const RobotDescription& description);

    /// Returns what is due after the robot sent @p sent.
    [[nodiscard]] std::vector<HardwareSample> step(const World& world,
                                                   const std::vector<HardwareSample>& sent);

    /// Pose of the map's frame in the arena.
    [[nodiscard]] static Pose mapInArena();

private:
    [[nodiscard]] OccupancyGridSample gridOf(const World& world) const;

    int m_robot;
    std::string m_frame;                        ///< of the map
    std::optional<OccupancyGridSample> m_grid;  ///< empty: the robot has no such stream
    Time m_gridDue{}, m_transformDue{};
};

}  // namespace leitstand::simulation
