#pragma once

#include <vector>

#include <QPainter>
#include <QRectF>

#include "core/perception/heat.h"
#include "widgets/camera/picture_image.h"

namespace leitstand {

/// The palette with its temperatures along the right edge of @p area.
void paintThermalScale(QPainter& painter, const QRectF& area, const ThermalRange& range,
                       ThermalPalette palette);
/// Frames around warm things in @p picture as it lies in @p area, bodies with a word.
void paintHeat(QPainter& painter, const QRectF& area, const ThermalPicture& picture,
               const std::vector<HeatBlob>& blobs);
/// The temperature at the pointer, beside it and within @p area.
void paintCelsius(QPainter& painter, const QRectF& area, const QPointF& pointer, float celsius);

}  // namespace leitstand
