#pragma once

#include <QRect>

class QPainter;
class QSize;

namespace leitstand {

struct OverlayStyle;
struct SceneContent;

/// What the colours of @p content mean, in the bottom left corner of a widget of @p size, or above @p taken
/// where they would meet. Returns its box; null where there is nothing to tell.
QRect paintLegend(QPainter& painter, const SceneContent& content, QSize size, const QRect& taken,
                  const OverlayStyle& style);

}  // namespace leitstand
