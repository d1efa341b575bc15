#pragma once

#include <vector>

#include <QPainter>
#include <QRectF>

#include "core/perception/heat/heat.h"
#include "widgets/camera/picture_image.h"

namespace leitstand {

/// The palette with its temperatures along the right edge of @p area.
void paintThermalScale(QPainter& painter, const QRectF& area, const ThermalRange& range,
                       ThermalPalette palette);
/// What paintThermalScale() needs of @p area.
[[nodiscard]] QRectF thermalScaleArea(const QRectF& area);
/// Frames around warm things in @p picture as it lies in @p area, bodies with a word within @p open that
/// keeps off what is @p taken.
void paintHeat(QPainter& painter, const QRectF& area, const ThermalPicture& picture,
               const std::vector<HeatBlob>& blobs, const QRectF& open, const std::vector<QRectF>& taken);
/// The temperature at the pointer, beside it and within @p area.
void paintCelsius(QPainter& painter, const QRectF& area, const QPointF& pointer, float celsius);

}  // namespace leitstand
