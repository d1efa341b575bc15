#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/handin/map/occupancy_grid.h"

namespace leitstand {

/// Writes @p grid as the two files that ROS 2's map_server loads: the picture @p image, a PGM, and beside it
/// a YAML file of the same name. Rows of the picture go from the largest y down; its pixels are 0 (occupied),
/// 254 (free) or 205 (unexplored). Confidences are not written. Each file appears whole or not at all.
[[nodiscard]] Result<void> writeGridMap(const std::filesystem::path& image, const OccupancyGrid& grid);

/// Reads a map of ROS's map_server by its YAML file. Its `image` is a binary PGM with 8 bits a pixel, its
/// `mode` trinary, scale or raw; in mode scale, what lies between the two thresholds is unexplored. Its
/// `origin` may not be turned. Errors name the file, the place and what was expected.
[[nodiscard]] Result<OccupancyGrid> readGridMap(const std::filesystem::path& yaml);

}  // namespace leitstand
