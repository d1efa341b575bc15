#pragma once

#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// Returns the index of the row whose Row::inMap is nearest to @p place, seen from above, within @p reach
/// [m]; -1: there is none. Lists use it to keep the selection on a thing that grows, shrinks or moves.
template <class Row>
[[nodiscard]] int nearestRow(const std::vector<Row>& rows, const Eigen::Vector3d& place, double reach) {
    int nearest = -1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double away = (rows[i].inMap - place).template head<2>().norm();
        if (away > reach) continue;
        reach = away;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

}  // namespace leitstand
