#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/handin/map/map_painter.h"

namespace leitstand {

/// Writes @p map as a GeoTIFF of 24-bit RGB: north is +x of the map, east is -y, a pixel further down is
/// further south (negative y pixel size). The map's frame is a local one, in metres, which the GeoKeys say.
/// Equal maps make equal bytes.
[[nodiscard]] Result<void> writeGeoTiff(const std::filesystem::path& file, const MapPicture& map);

/// Reads what writeGeoTiff() wrote, and any RGB GeoTIFF of square pixels without rotation. Errors name the
/// file and what was expected.
[[nodiscard]] Result<MapPicture> readGeoTiff(const std::filesystem::path& file);

}  // namespace leitstand
