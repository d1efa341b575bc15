#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/handin/map/map_painter.h"

namespace leitstand {

/// Paints shapes, given in the map [m], into a picture of it; never a colour between two others.
class MapCanvas {
public:
    explicit MapCanvas(MapPicture map) : m_map(std::move(map)) {}
    [[nodiscard]] const MapPicture& map() const { return m_map; }
    [[nodiscard]] MapPicture take() && { return std::move(m_map); }

    /// A pixel; outside nothing happens.
    void set(int column, int row, Rgb colour);
    void disc(const Eigen::Vector2d& centre, double across, Rgb colour);
    /// A square on its tip.
    void diamond(const Eigen::Vector2d& centre, double side, Rgb colour);
    /// A bar from its upper left corner: @p along to the right and @p down.
    void bar(const Eigen::Vector2d& upperLeft, double along, double down, Rgb colour);
    void polygon(const std::vector<Eigen::Vector2d>& corners, Rgb colour);
    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double wide, Rgb colour);
    void polyline(const std::vector<Eigen::Vector2d>& points, double wide, Rgb colour);
    /// @p text with capitals of @p height; @p lowerLeft is where its base line begins.
    void text(const Eigen::Vector2d& lowerLeft, const std::string& text, double height, Rgb colour);
    /// Likewise, its middle at @p centre.
    void centredText(const Eigen::Vector2d& centre, const std::string& text, double height, Rgb colour);
    /// How wide @p text becomes [m].
    [[nodiscard]] static double textWidth(const std::string& text, double height, double perPixel);

private:
    template <class Inside>
    void fill(const Eigen::Vector2d& centre, double reach, Rgb colour, Inside inside);

    MapPicture m_map;
};

}  // namespace leitstand
