#pragma once

class QPainter;
class QSize;

namespace leitstand {

struct OverlayStyle;
struct SceneContent;

/// What the colours of @p content mean, in the bottom left corner of a widget of @p size.
void paintLegend(QPainter& painter, const SceneContent& content, QSize size, const OverlayStyle& style);

}  // namespace leitstand
