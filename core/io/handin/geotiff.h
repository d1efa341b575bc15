#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/handin/map/map_painter.h"

namespace leitstand {

/// Writes @p map as a GeoTIFF of 24-bit RGB. North is +x of the map, east is -y. Rows run from north to south
/// (negative y pixel size). In the GeoKeys the frame of the map is local, in metres. Equal maps give equal
/// bytes.
[[nodiscard]] Result<void> writeGeoTiff(const std::filesystem::path& file, const MapPicture& map);

/// Reads a GeoTIFF of writeGeoTiff(), or any other RGB GeoTIFF with square pixels and no rotation. Errors
/// name the file and what was expected.
[[nodiscard]] Result<MapPicture> readGeoTiff(const std::filesystem::path& file);

}  // namespace leitstand
