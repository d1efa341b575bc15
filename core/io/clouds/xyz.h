#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// Reads a text of points: x y z [m], right-handed, separated by blanks, commas or semicolons. A fourth
/// number is the intensity, unless a comment in the first line ("# x y z label") names the columns. NaN means
/// no echo.
[[nodiscard]] Result<ScanReading> readXyz(const std::filesystem::path& file);

/// Writes @p scan so that readXyz() returns the same points, intensities and labels. The grid is not written.
/// readXyz() finds it again if the points lie in the grid of a scanner.
[[nodiscard]] Result<void> writeXyz(const std::filesystem::path& file, const Scan& scan);

}  // namespace leitstand
