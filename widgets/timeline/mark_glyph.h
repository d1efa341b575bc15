#pragma once

#include <QFont>
#include <QPainter>
#include <QPointF>

#include "widgets/models/timeline/timeline_words.h"

namespace leitstand {

/// Paints @p glyph's shape with its middle at @p middle; some 14 px wide.
void paintMark(QPainter& painter, const TimelineGlyph& glyph, const QPointF& middle, const QFont& font);

}  // namespace leitstand
