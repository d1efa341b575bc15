#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/handin/map/map_painter.h"

class QPainter;

namespace leitstand {

/// Where names beside places on a map can be put.
struct CalloutRoom {
    QRectF room;         ///< contains all names
    double clear = 0.0;  ///< radius around each place that must not be covered [dots]
};

/// Returns a box for each of @p places, with the size at the same index in @p sizes, as near to the place as
/// possible. Boxes do not overlap. If there is enough space, they cover neither places nor the lines from
/// boxes to their places. A box that fits nowhere is centred on its place.
[[nodiscard]] std::vector<QRectF> placeCallouts(const std::vector<QPointF>& places,
                                                const std::vector<QSizeF>& sizes,
                                                const CalloutRoom& settings);

/// Draws the names of @p marks on @p map, which fills @p picture. Names have the same size on all maps, so
/// that they are legible.
void drawCallouts(QPainter& painter, const QRectF& picture, const MapPicture& map,
                  const std::vector<MapMark>& marks);

inline constexpr double ScaleHeight = 44.0;  ///< height of what drawScale() draws [dots; 96 per inch]

/// Draws the directions of x and y, and a scale bar. @p corner: upper left corner of the drawing. @p dots:
/// dots per metre of the map. The bar is 1 m long, or 10 m if 1 m would be too short to read.
void drawScale(QPainter& painter, const QPointF& corner, double dots);

}  // namespace leitstand
