#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/handin/map/map_drawing.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// How a map is painted.
struct PaintSettings {
    std::optional<MapArea> area = {};  ///< what to paint; empty: everything, with space for the title above
    double perPixel = 0.0;  ///< size of a pixel [m]; 0: 0.01, or larger so that at most mostPixels are needed
    double mostPixels = 36e6;
    bool title = true;  ///< whether to paint title, scale bar and the directions of x and y
    bool names = true;  ///< whether to paint names beside marks that contain no number
};

/// A picture of a map: +x of the map is up, +y is left.
struct MapPicture {
    Picture picture;                                    ///< in Rgb8
    Eigen::Vector2d topLeft = Eigen::Vector2d::Zero();  ///< corner of the first pixel in the map [m]
    double perPixel = 0.01;                             ///< edge of a pixel [m]

    /// Returns column and row of a place in the map [m], with fractions. They may be outside of the picture.
    [[nodiscard]] Eigen::Vector2d pixelOf(const Eigen::Vector2d& place) const {
        return {(topLeft.y() - place.y()) / perPixel, (topLeft.x() - place.x()) / perPixel};
    }
    /// Returns the colour of a pixel within the picture.
    [[nodiscard]] Rgb at(int column, int row) const;
};

/// Sizes that the rules require [m].
namespace map_size {
inline constexpr double Disc = 0.35;     ///< diameter
inline constexpr double Diamond = 0.30;  ///< side of the square
inline constexpr double Path = 0.02;     ///< width
inline constexpr double Grid = 0.5;      ///< distance between lines
inline constexpr double Checker = 1.0;   ///< side of a square
inline constexpr double ScaleBar = 1.0;  ///< length
inline constexpr double Arrow = 0.6;     ///< length
}  // namespace map_size

/// Paints @p drawing in the colours, sizes and layers of the rules: unexplored, explored, grid, cleared,
/// walls, paths, marks, text. Edges are not smoothed, so that no other colours appear.
[[nodiscard]] MapPicture paintMap(const MapDrawing& drawing, const PaintSettings& settings = {});

}  // namespace leitstand
