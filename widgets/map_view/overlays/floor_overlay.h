#pragma once

#include <QRect>
#include <QSize>

class QPainter;

namespace leitstand {

class MapProjection;
struct FloorTint;
struct OverlayStyle;

/// The floor that was searched in a tint, what was missed of it hatched.
void paintFloorTint(QPainter& painter, const MapProjection& projection, const FloorTint& tint,
                    const OverlayStyle& style);
/// What tint and hatch mean, in a box above @p below (the legend's; may be null) at the left of a widget of
/// @p size.
void paintFloorLegend(QPainter& painter, const FloorTint& tint, QSize size, const QRect& below,
                      const OverlayStyle& style);

}  // namespace leitstand
