#pragma once

#include <QRect>

class QPainter;
class QSize;

namespace leitstand {

struct OverlayStyle;
struct SceneContent;

/// Paints what the colours of @p content mean, in the bottom left corner of a widget of @p size. If the
/// legend would overlap @p taken, it is painted above it. Returns the box of the legend; null: nothing was
/// painted.
QRect paintLegend(QPainter& painter, const SceneContent& content, QSize size, const QRect& taken,
                  const OverlayStyle& style);

}  // namespace leitstand
