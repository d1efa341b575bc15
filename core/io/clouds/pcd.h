#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// How the points of a PCD file are stored.
enum class PcdEncoding : std::uint8_t { Ascii, Binary, BinaryCompressed };

/// Reads a PCD file (0.7): x y z [m], and intensity and label if present. A cloud with HEIGHT above 1 is
/// organised; NaN means no echo. The viewpoint is ignored. Bodies are read in chunks. Compressed bodies are
/// decoded by the LZF of pcl_io.
[[nodiscard]] Result<ScanReading> readPcd(const std::filesystem::path& file);

/// Writes @p scan so that readPcd() returns the same points, grid, intensities and labels. A compressed body
/// is limited to 2 GB.
[[nodiscard]] Result<void> writePcd(const std::filesystem::path& file, const Scan& scan,
                                    PcdEncoding encoding = PcdEncoding::Binary);

}  // namespace leitstand
