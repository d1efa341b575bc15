#pragma once

#include <filesystem>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"
#include "core/io/detail/numbers.h"

namespace leitstand::detail {

/// How the lines of a text of points are to be read: three coordinates, a fourth number is the intensity,
/// what follows is not looked at; every line has as many fields as the first.
struct PointTextFormat {
    Separators separators = Separators::Blanks;
    bool gridHeader = false;    ///< "ROWS x COLUMNS" may stand before the first point
    bool columnNames = false;   ///< a comment such as "# x y z intensity label" may say what the columns are
    bool zeroIsNoEcho = false;  ///< a point at the very origin
    /// The file's numbers in our axes [m].
    Eigen::Vector3d (*toMetres)(const Eigen::Vector3d& inFile) = [](const Eigen::Vector3d& p) { return p; };
};

/// Reads the points, intensities and labels of @p path and the grid that they lie in, into memory that is
/// reserved once. Blank lines and comments ("#" or "//" first) are left out.
[[nodiscard]] Result<ScanReading> readPointText(const std::filesystem::path& path,
                                                const PointTextFormat& format);

}  // namespace leitstand::detail
