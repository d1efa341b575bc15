#pragma once

#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// The place among @p rows of the one whose Row::inMap is nearest to @p place, seen from above, within @p
/// reach [m]; -1: there is none. So a choice stays with what it was made of while that grows, shrinks or
/// moves.
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
