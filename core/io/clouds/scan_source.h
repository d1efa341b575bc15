#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// Lists the scan files of @p sources, in order. A folder contributes its scanNNN.3d, sorted by number; a
/// file of a CloudFormat contributes itself. Error when a source is neither; it names the source.
[[nodiscard]] Result<std::vector<std::filesystem::path>> listScans(
    const std::vector<std::filesystem::path>& sources);

/// Reads the scan in @p file, whose ending names its CloudFormat. Error when no format has that ending.
[[nodiscard]] Result<ScanReading> readScan(const std::filesystem::path& file);

}  // namespace leitstand
