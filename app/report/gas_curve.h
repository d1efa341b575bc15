#pragma once

#include <QRectF>

#include "app/services/handin/report_content.h"

class QPainter;

namespace leitstand {

/// Whether there is enough to draw a curve of.
[[nodiscard]] bool isCurve(const GasTrace& trace);

/// Draws the CO2 of @p trace over time into @p room, with axes, their names and a title; in the painter's
/// font.
void drawGasCurve(QPainter& painter, const QRectF& room, const GasTrace& trace);

}  // namespace leitstand
