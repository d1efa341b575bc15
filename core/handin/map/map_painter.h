#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/handin/map/map_drawing.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// How a map is painted.
struct PaintSettings {
    std::optional<MapArea> area = {};  ///< what to paint; empty: everything, with room for the title above
    double perPixel = 0.0;             ///< [m]; 0: 0.01, or coarser, so that at most mostPixels are needed
    double mostPixels = 36e6;
    bool title = true;  ///< paint title, scale bar and the directions of x and y
    bool names = true;  ///< paint names beside the marks that have no number in them
};

/// A picture of a map: x of the map is up, y is left.
struct MapPicture {
    Picture picture;                                    ///< Rgb8
    Eigen::Vector2d topLeft = Eigen::Vector2d::Zero();  ///< corner of the first pixel, in the map [m]
    double perPixel = 0.01;                             ///< edge of a pixel [m]

    /// Returns column and row of a place in the map [m], with fractions. They may lie outside of the picture.
    [[nodiscard]] Eigen::Vector2d pixelOf(const Eigen::Vector2d& place) const {
        return {(topLeft.y() - place.y()) / perPixel, (topLeft.x() - place.x()) / perPixel};
    }
    /// Returns the colour of a pixel within the picture.
    [[nodiscard]] Rgb at(int column, int row) const;
};

/// Sizes that the rules ask for [m].
namespace map_size {
inline constexpr double Disc = 0.35;     ///< across
inline constexpr double Diamond = 0.30;  ///< side
inline constexpr double Path = 0.02;     ///< wide
inline constexpr double Grid = 0.5;      ///< from line to line
inline constexpr double Checker = 1.0;   ///< side of a square
inline constexpr double ScaleBar = 1.0;  ///< long
inline constexpr double Arrow = 0.6;     ///< long
}  // namespace map_size

/// Paints @p drawing in the colours, sizes and layers of the rules: unexplored, explored, grid, cleared,
/// walls, paths, marks, text. Edges are not smoothed, so that no other colours occur.
[[nodiscard]] MapPicture paintMap(const MapDrawing& drawing, const PaintSettings& settings = {});

}  // namespace leitstand
