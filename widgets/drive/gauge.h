#pragma once

#include <QFont>
#include <QPainter>
#include <QWidget>

#include "widgets/models/live/robots/drive_state.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {

/// Font sizes of the drive strip: captions, the main number of a gauge, smaller numbers.
inline constexpr int CaptionSize = 12, NumberSize = 24, FigureSize = 19;  ///< [px]

/// Paints a caption left-aligned into @p line, elided when it is too long.
void paintCaption(QPainter& painter, const QRectF& line, const QString& text, const QColor& colour);
/// Paints a number and its unit, and returns their right edge [px]. The unit is left out when there is no
/// room.
double paintFigure(QPainter& painter, const QRectF& line, const Figure& figure, int pixels,
                   const ThemeColours& colours);

}  // namespace leitstand
