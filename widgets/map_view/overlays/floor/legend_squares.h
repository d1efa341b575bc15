#pragma once

#include <functional>
#include <vector>

#include <QRect>
#include <QSize>
#include <QString>

class QPainter;
class QPainterPath;

namespace leitstand {

struct OverlayStyle;

/// A square of a legend and what it means.
struct LegendSquare {
    std::function<void(QPainter&, const QPainterPath&)> fill;  ///< paints the square; empty: a text alone
    QString text;
};

/// Paints @p squares in a row into a box at the left of a widget of @p size. It is above @p below, the box
/// under it (may be null). Returns the box.
QRect paintLegendSquares(QPainter& painter, const std::vector<LegendSquare>& squares, QSize size,
                         const QRect& below, const OverlayStyle& style);

}  // namespace leitstand
