#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>

#include "core/perception/omni/panorama.h"

namespace leitstand {

/// Marks a panorama that fills @p area: the horizon, the robot's front, and directions along the lower edge.
void paintPanorama(QPainter& painter, const QRectF& area, const PanoramaShape& shape);
/// Marks the robot's front in an omnidirectional picture that fills @p area. @p ahead: shares of width and
/// height (0 to 1).
void paintFront(QPainter& painter, const QRectF& area, const QPointF& ahead);

}  // namespace leitstand
