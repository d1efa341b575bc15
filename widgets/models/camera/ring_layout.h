#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "widgets/models/live/robots/proximity.h"

namespace leitstand {

/// Returns the circle of the proximity ring in @p picture. It lies between @p top, the lower edge of the
/// mode, and @p bottom, the upper edge of the words about the camera [px]. Empty when there is no room for a
/// ring with figures.
[[nodiscard]] QRectF ringCircle(const QRectF& picture, double top, double bottom);

/// A distance that is written into the proximity ring.
struct RingFigure {
    QPointF at;            ///< middle of the text [px]
    std::size_t part = 0;  ///< index in the ring
    bool loud = false;     ///< the part is Near or Touching
};
/// Returns the figures to write within @p circle: for each part of @p ring that is Near or Touching, and for
/// the nearest part. Where two would overlap, only that of the nearer part stays. @p size: of a loud figure,
/// the largest kind.
[[nodiscard]] std::vector<RingFigure> ringFigures(const std::vector<Proximity>& ring, const QRectF& circle,
                                                  const QSizeF& size);

}  // namespace leitstand
