#pragma once

#include <QFont>
#include <QPainter>
#include <QWidget>

#include "widgets/models/live/robots/drive_state.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {

/// Fonts of the drive strip: captions, the one number of a gauge, smaller numbers.
inline constexpr int CaptionSize = 12, NumberSize = 24, FigureSize = 19;  ///< [px]

/// Paints a caption into the left of @p line, cut with dots when it is too long.
void paintCaption(QPainter& painter, const QRectF& line, const QString& text, const QColor& colour);
/// Paints a number and its unit, and returns where it ends. The unit gives way to the number.
double paintFigure(QPainter& painter, const QRectF& line, const Figure& figure, int pixels,
                   const ThemeColours& colours);

}  // namespace leitstand
