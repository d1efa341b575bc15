#pragma once

#include <filesystem>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"
#include "core/io/detail/numbers.h"

namespace leitstand::detail {

/// Format of a text with one point per line. Three coordinates come first; a fourth number is the intensity;
/// other fields are ignored. Every line has as many fields as the first.
struct PointTextFormat {
    Separators separators = Separators::Blanks;
    bool gridHeader = false;    ///< "ROWS x COLUMNS" may stand before the first point
    bool columnNames = false;   ///< a comment such as "# x y z intensity label" may name the columns
    bool zeroIsNoEcho = false;  ///< a point exactly at the origin is no echo
    /// converts coordinates of the file to our axes [m]
    Eigen::Vector3d (*toMetres)(const Eigen::Vector3d& inFile) = [](const Eigen::Vector3d& p) { return p; };
};

/// Reads points, intensities, labels and grid of @p path. Reserves the memory once. Skips blank lines and
/// comments (lines that begin with "#" or "//").
[[nodiscard]] Result<ScanReading> readPointText(const std::filesystem::path& path,
                                                const PointTextFormat& format);

}  // namespace leitstand::detail
