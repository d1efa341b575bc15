#pragma once

#include <vector>

#include <QPainter>
#include <QRectF>

#include "core/perception/heat/heat.h"
#include "widgets/camera/picture_image.h"

namespace leitstand {

/// Paints the palette with its temperatures along the right edge of @p area.
void paintThermalScale(QPainter& painter, const QRectF& area, const ThermalRange& range,
                       ThermalPalette palette);
/// Returns the part of @p area that paintThermalScale() needs.
[[nodiscard]] QRectF thermalScaleArea(const QRectF& area);
/// Frames warm things in @p picture, which fills @p area. Bodies also get a label, which is within @p open
/// and does not cover @p taken.
void paintHeat(QPainter& painter, const QRectF& area, const ThermalPicture& picture,
               const std::vector<HeatBlob>& blobs, const QRectF& open, const std::vector<QRectF>& taken);
/// Paints the temperature at the pointer, beside it and within @p area.
void paintCelsius(QPainter& painter, const QRectF& area, const QPointF& pointer, float celsius);

}  // namespace leitstand
