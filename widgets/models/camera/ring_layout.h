#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "widgets/models/live/robots/proximity.h"

namespace leitstand {

/// Returns the circle of the proximity ring in @p picture. It is between @p top, the lower edge of the mode,
/// and @p bottom, the upper edge of the words about the camera [px]. Empty when there is not enough space for
/// a ring with figures.
[[nodiscard]] QRectF ringCircle(const QRectF& picture, double top, double bottom);

/// A distance that is written in the proximity ring.
struct RingFigure {
    QPointF at;            ///< middle of the text [px]
    std::size_t part = 0;  ///< index of the part in the ring
    bool loud = false;     ///< whether the part is Near or Touching
};
/// Returns the figures to write within @p circle: for each part of @p ring that is Near or Touching, and for
/// the nearest part. If two would overlap, only the figure of the nearer part is kept. @p size: size of a
/// loud figure, which is the largest kind.
[[nodiscard]] std::vector<RingFigure> ringFigures(const std::vector<Proximity>& ring, const QRectF& circle,
                                                  const QSizeF& size);

}  // namespace leitstand
