#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/mapping/live/map/live_map.h"
#include "core/robot/robot_description.h"

namespace leitstand::test {

/// Adds key scans to the mission in @p folder, which nobody has open, until it has @p count: those of @p map
/// again and again, each where it is. What robots scan next still fits.
void growMap(const std::filesystem::path& folder, const std::vector<RobotDescription>& robots,
             const LiveMap& map, std::size_t count);

}  // namespace leitstand::test
