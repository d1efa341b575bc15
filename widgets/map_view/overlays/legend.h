#pragma once

#include <QRect>

class QPainter;
class QSize;

namespace leitstand {

struct OverlayStyle;
struct SceneContent;

/// Paints what the colours of @p content mean, in the bottom left corner of a widget of @p size, or above
/// @p taken if they would overlap. Returns its box; null when it paints nothing.
QRect paintLegend(QPainter& painter, const SceneContent& content, QSize size, const QRect& taken,
                  const OverlayStyle& style);

}  // namespace leitstand
