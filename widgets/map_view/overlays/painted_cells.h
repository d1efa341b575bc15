#pragma once

#include <vector>

#include <QPointF>
#include <QSize>

namespace leitstand {

/// Marks the cells of a widget that are painted, so that nothing is painted twice on the same place. The cost
/// of an hour's marks is then bounded by the widget's size.
class PaintedCells {
public:
    /// @p size: of the widget. @p cell: edge of what counts as one place. Both in logical pixels.
    PaintedCells(QSize size, double cell);

    /// Marks the place; true if it was not marked before. False for places outside the widget.
    bool take(const QPointF& place);
    /// Marks all places between @p from and @p to; true if one of them was not marked before. A line that
    /// crosses the widget and is longer than 1000 cells marks nothing and returns true.
    bool takeLine(const QPointF& from, const QPointF& to);

private:
    double m_cell;
    int m_columns, m_rows;
    std::vector<bool> m_taken;
};

}  // namespace leitstand
