#include "widgets/map_view/render/detail_budget.h"

#include <algorithm>

namespace leitstand {

void DetailBudget::drawn(std::size_t points, Seconds time) {
    if (points < Least || time <= Seconds::zero()) return;
    // A single slow or quick frame proves little: never change by more than a factor of two.
    const double change = std::clamp(m_frameTime / time, 0.5, 2.0);
    const bool limited = points >= m_points;
    if (change > 1.0 && !limited) return;
    const auto wanted = static_cast<std::size_t>(static_cast<double>(std::min(points, m_points)) * change);
    m_points = std::clamp((m_points + wanted) / 2, Least, Most);
}

}  // namespace leitstand
