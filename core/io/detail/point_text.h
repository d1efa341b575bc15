#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/io/detail/numbers.h"

namespace leitstand::detail {

/// How the lines of a text of points are to be read: three coordinates, a fourth number is the intensity,
/// what follows is not looked at; every line has as many fields as the first.
struct PointTextFormat {
    Separators separators = Separators::Blanks;
    bool gridHeader = false;    ///< "ROWS x COLUMNS" may stand before the first point
    bool zeroIsNoEcho = false;  ///< a point at the very origin
    /// The file's numbers in our axes [m].
    Eigen::Vector3d (*toMetres)(const Eigen::Vector3d& inFile) = [](const Eigen::Vector3d& p) { return p; };
};

/// The points of a text file.
struct PointText {
    int rows = 0, columns = 0;            ///< as the header says; 0 x 0 without
    std::vector<Eigen::Vector3f> points;  ///< [m], our axes; NaN: no echo
    std::vector<float> intensities;       ///< empty, or one per point
};

/// Reads @p path into memory that is reserved once. Blank lines and lines that begin with '#' are left out.
[[nodiscard]] Result<PointText> readPointText(const std::filesystem::path& path,
                                              const PointTextFormat& format);

}  // namespace leitstand::detail
