#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "widgets/models/live/robots/proximity.h"

namespace leitstand {

/// Returns the circle of the proximity ring in @p picture, between @p top, where the mode ends, and @p
/// bottom, where words about the camera begin [px]. Empty when it has no room for its figures.
[[nodiscard]] QRectF ringCircle(const QRectF& picture, double top, double bottom);

/// A figure of the proximity ring.
struct RingFigure {
    QPointF at;            ///< its middle [px]
    std::size_t part = 0;  ///< index in the ring
    bool loud = false;     ///< of something near
};
/// Returns the figures within @p circle: of all that is near and of the nearest part. Where two would
/// overlap, the one of the nearer part stays. @p size: of a figure; loud ones are the largest.
[[nodiscard]] std::vector<RingFigure> ringFigures(const std::vector<Proximity>& ring, const QRectF& circle,
                                                  const QSizeF& size);

}  // namespace leitstand
