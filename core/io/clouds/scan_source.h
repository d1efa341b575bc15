#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// Lists the scan files of @p sources, in their order. A folder gives its scanNNN.3d, sorted by number; a
/// file of a CloudFormat gives itself. Any other source is an error that names it.
[[nodiscard]] Result<std::vector<std::filesystem::path>> listScans(
    const std::vector<std::filesystem::path>& sources);

/// Reads the scan in @p file. The ending of the file decides about the CloudFormat. Error when no format has
/// that ending.
[[nodiscard]] Result<ScanReading> readScan(const std::filesystem::path& file);

}  // namespace leitstand
