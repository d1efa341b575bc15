#pragma once

#include <QFont>
#include <QPainter>
#include <QPointF>

#include "widgets/models/timeline/timeline_text.h"

namespace leitstand {

/// Paints the shape of @p glyph centred at @p middle, about 14 px wide.
void paintMark(QPainter& painter, const TimelineGlyph& glyph, const QPointF& middle, const QFont& font);

}  // namespace leitstand
