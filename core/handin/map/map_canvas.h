#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/handin/map/map_painter.h"

namespace leitstand {

/// Paints shapes into a picture of the map. Places and lengths are those of the map [m]. Colours are never
/// mixed.
class MapCanvas {
public:
    explicit MapCanvas(MapPicture map) : m_map(std::move(map)) {}
    [[nodiscard]] const MapPicture& map() const { return m_map; }
    [[nodiscard]] MapPicture take() && { return std::move(m_map); }

    /// Sets a pixel; does nothing outside the picture.
    void set(int column, int row, Rgb colour);
    void disc(const Eigen::Vector2d& centre, double across, Rgb colour);
    /// Paints a square that stands on one of its corners.
    void diamond(const Eigen::Vector2d& centre, double side, Rgb colour);
    /// Paints a bar from its upper left corner, @p along wide and @p down high, at least one pixel each.
    void bar(const Eigen::Vector2d& upperLeft, double along, double down, Rgb colour);
    void polygon(const std::vector<Eigen::Vector2d>& corners, Rgb colour);
    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double wide, Rgb colour);
    void polyline(const std::vector<Eigen::Vector2d>& points, double wide, Rgb colour);
    /// Paints @p text in capitals of @p height. Its base line begins at @p lowerLeft.
    void text(const Eigen::Vector2d& lowerLeft, const std::string& text, double height, Rgb colour);
    /// Paints @p text with its middle at @p centre.
    void centredText(const Eigen::Vector2d& centre, const std::string& text, double height, Rgb colour);
    /// Returns the width [m] of @p text in capitals of @p height [m], in a picture with pixels of @p perPixel
    /// [m].
    [[nodiscard]] static double textWidth(const std::string& text, double height, double perPixel);

private:
    template <class Inside>
    void fill(const Eigen::Vector2d& centre, double reach, Rgb colour, Inside inside);

    MapPicture m_map;
};

}  // namespace leitstand
