#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/handin/map/map_painter.h"

class QPainter;

namespace leitstand {

/// Where names stand beside what they name.
struct CalloutRoom {
    QRectF room;         ///< all of them are in it
    double clear = 0.0;  ///< about each place, nothing but a line to it may be
};

/// A box of each of @p sizes beside the one of @p places with its number, as near as it fits: none over
/// another, nor, where there is room for that, over places or over the lines from boxes to their places.
[[nodiscard]] std::vector<QRectF> placeCallouts(const std::vector<QPointF>& places,
                                                const std::vector<QSizeF>& sizes,
                                                const CalloutRoom& settings);

/// Names @p marks of @p map, which is drawn as @p picture, so that they can be read however large the map is.
void drawCallouts(QPainter& painter, const QRectF& picture, const MapPicture& map,
                  const std::vector<MapMark>& marks);

inline constexpr double ScaleHeight = 44.0;  ///< of what drawScale() draws [dots of 1/96 inch]

/// From @p corner, its upper left one: which way x and y go, and a bar of a metre, or of ten where that would
/// be a speck, of a map with so many @p dots a metre.
void drawScale(QPainter& painter, const QPointF& corner, double dots);

}  // namespace leitstand
