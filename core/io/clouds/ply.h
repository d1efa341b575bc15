#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// How the points of a PLY file are stored; binary is little-endian.
enum class PlyEncoding : std::uint8_t { Ascii, Binary };

/// Reads the vertices of a PLY file (1.0; ascii, little- or big-endian): x y z [m], and intensity and label
/// if present. NaN means no echo. "obj_info num_cols" and "num_rows" give the grid of an organised scan.
[[nodiscard]] Result<ScanReading> readPly(const std::filesystem::path& file);

/// Writes @p scan so that readPly() returns the same points, grid, intensities and labels.
[[nodiscard]] Result<void> writePly(const std::filesystem::path& file, const Scan& scan,
                                    PlyEncoding encoding = PlyEncoding::Binary);

}  // namespace leitstand
