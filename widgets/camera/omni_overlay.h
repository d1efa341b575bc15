#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>

#include "core/perception/omni/panorama.h"

namespace leitstand {

/// Directions along the lower edge of a panorama that lies in @p area, its horizon, and where the robot's
/// front is.
void paintPanorama(QPainter& painter, const QRectF& area, const PanoramaShape& shape);
/// The robot's front in an omnidirectional picture that lies in @p area; @p ahead: 0 to 1 of both sides.
void paintFront(QPainter& painter, const QRectF& area, const QPointF& ahead);

}  // namespace leitstand
