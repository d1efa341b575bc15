#pragma once

class QPainter;
class QSize;
class QString;

namespace leitstand {

struct OverlayStyle;

/// Paints @p text at the upper edge of a widget of @p size: what the next click does, or what is missing.
void paintHint(QPainter& painter, const QString& text, QSize size, const OverlayStyle& style);

}  // namespace leitstand
