#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// The scan files behind @p sources, in order: a folder stands for its scanNNN.3d, sorted by number, a file
/// of a CloudFormat for itself. An error names the source that is neither.
[[nodiscard]] Result<std::vector<std::filesystem::path>> listScans(
    const std::vector<std::filesystem::path>& sources);

/// Reads the scan in @p file, whose CloudFormat its ending tells.
[[nodiscard]] Result<ScanReading> readScan(const std::filesystem::path& file);

}  // namespace leitstand
