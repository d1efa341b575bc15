#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/handin/map/map_painter.h"

class QPainter;

namespace leitstand {

/// Room for names beside the places that they name.
struct CalloutRoom {
    QRectF room;         ///< contains all names
    double clear = 0.0;  ///< radius around each place that boxes leave free [dots]
};

/// Returns a box of each of @p sizes beside the place of the same index, as near as it fits. Boxes do not
/// overlap. When there is room, they hide neither places nor the lines from boxes to their places. A box
/// without any room is centred on its place.
[[nodiscard]] std::vector<QRectF> placeCallouts(const std::vector<QPointF>& places,
                                                const std::vector<QSizeF>& sizes,
                                                const CalloutRoom& settings);

/// Draws the names of @p marks on @p map, which is drawn as @p picture. They can be read at any size of the
/// map.
void drawCallouts(QPainter& painter, const QRectF& picture, const MapPicture& map,
                  const std::vector<MapMark>& marks);

inline constexpr double ScaleHeight = 44.0;  ///< height of what drawScale() draws [dots of 1/96 inch]

/// Draws the directions of x and y and a scale bar, with @p corner as the upper left corner. The map has @p
/// dots per metre. The bar is 1 m long, or 10 m when 1 m would be too short to read.
void drawScale(QPainter& painter, const QPointF& corner, double dots);

}  // namespace leitstand
