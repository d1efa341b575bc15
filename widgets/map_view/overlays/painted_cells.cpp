#include "widgets/map_view/overlays/painted_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <QRectF>

namespace leitstand {

PaintedCells::PaintedCells(QSize size, double cell)
    : m_cell(cell),
      m_columns(static_cast<int>(std::ceil(size.width() / cell))),
      m_rows(static_cast<int>(std::ceil(size.height() / cell))),
      m_taken(static_cast<std::size_t>(std::max(0, m_columns)) *
              static_cast<std::size_t>(std::max(0, m_rows))) {}

bool PaintedCells::take(const QPointF& place) {
    const double x = std::floor(place.x() / m_cell), y = std::floor(place.y() / m_cell);
    if (!(x >= 0.0 && x < m_columns && y >= 0.0 && y < m_rows)) return false;
    const auto cell =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(x);
    const bool isNew = !m_taken[cell];
    m_taken[cell] = true;
    return isNew;
}

bool PaintedCells::takeLine(const QPointF& from, const QPointF& to) {
    const QRectF widget(0.0, 0.0, m_columns * m_cell, m_rows * m_cell);
    const QPointF low(std::min(from.x(), to.x()), std::min(from.y(), to.y()));
    const QPointF high(std::max(from.x(), to.x()), std::max(from.y(), to.y()));
    if (!(low.x() < widget.right() && high.x() > 0.0 && low.y() < widget.bottom() && high.y() > 0.0))
        return false;
    const QPointF way = to - from;
    // Very long lines lie mostly outside the widget: they count as new.
    constexpr double Longest = 1000.0;  // cells
    const double steps = std::ceil(std::hypot(way.x(), way.y()) / m_cell);
    if (!(steps <= Longest)) return true;
    bool isNew = take(from);
    for (double step = 1.0; step <= steps; ++step) isNew = take(from + step / steps * way) || isNew;
    return isNew;
}

}  // namespace leitstand
