#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/mapping/scripted_drive.h"

namespace leitstand::simulation::test {

/// Two robots of which nobody knows how they stand to each other, each on its way.
struct TwoDrives {
    ScriptedDrive first, second;  ///< "kurt3d" and "second"
};

/// Of the ring, once around, from share @p from to @p to; backwards where that is less.
[[nodiscard]] std::vector<Eigen::Vector3d> stretch(const BuildingWays& ways, double from, double to);
/// Calls the robot of @p drive @p robot.
void rename(ScriptedDrive& drive, const std::string& robot);

/// The first goes along more than half of the ring, the second comes towards it.
[[nodiscard]] TwoDrives twoDrives(const Building& building, const SensorErrors& sensor, std::uint64_t seed);

}  // namespace leitstand::simulation::test
