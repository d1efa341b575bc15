#pragma once

#include <vector>

#include <QPointF>
#include <QSize>

namespace leitstand {

/// Which parts of a widget something was painted on, so that what lies on the same place again need not be
/// painted: an hour's marks cost no more than there is room for.
class PaintedCells {
public:
    /// @p size of the widget, @p cell of what counts as one place; both in logical pixels.
    PaintedCells(QSize size, double cell);

    /// Marks the place; true where it was not marked before. Places outside the widget never are new.
    bool take(const QPointF& place);
    /// Marks all places between @p from and @p to; true where one of them was not marked before.
    bool takeLine(const QPointF& from, const QPointF& to);

private:
    double m_cell;
    int m_columns, m_rows;
    std::vector<bool> m_taken;
};

}  // namespace leitstand
