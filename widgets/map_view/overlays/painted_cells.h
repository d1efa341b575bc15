#pragma once

#include <vector>

#include <QPointF>
#include <QSize>

namespace leitstand {

/// Marks which cells of a widget are painted, so that nothing is painted twice at the same place. So the cost
/// of marks from a whole hour is limited by the widget's size.
class PaintedCells {
public:
    /// @p size: size of the widget. @p cell: edge of a cell. Both in logical pixels.
    PaintedCells(QSize size, double cell);

    /// Marks the cell at @p place. True if it was not marked before; false outside the widget.
    bool take(const QPointF& place);
    /// Marks all cells between @p from and @p to. True if one of them was not marked before. A line that
    /// crosses the widget and is longer than 1000 cells marks nothing and returns true.
    bool takeLine(const QPointF& from, const QPointF& to);

private:
    double m_cell;
    int m_columns, m_rows;
    std::vector<bool> m_taken;
};

}  // namespace leitstand
