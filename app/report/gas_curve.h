#pragma once

#include <QRectF>

#include "app/services/handin/report_content.h"

class QPainter;

namespace leitstand {

/// Whether @p trace has enough readings for a curve.
[[nodiscard]] bool isCurve(const GasTrace& trace);

/// Draws the CO2 of @p trace over time into the rectangle @p room, with axes, their names and a title. Uses
/// the painter's font.
void drawGasCurve(QPainter& painter, const QRectF& room, const GasTrace& trace);

}  // namespace leitstand
