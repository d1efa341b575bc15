#include "core/mapping/comparison/found_victims.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace leitstand {
namespace {

constexpr double Apart = 1e6;  // cost of a pair that is out of reach: more than all others together

/// Returns the column of each row so that the sum of @p costs is least. No more rows than columns.
std::vector<std::size_t> assigned(const std::vector<std::vector<double>>& costs) {
    const std::size_t rows = costs.size(), columns = rows == 0 ? 0 : costs.front().size();
    // Potentials of rows and columns, from 1; 0 is the row that looks for its column.
    std::vector<double> ofRow(rows + 1), ofColumn(columns + 1);
    std::vector<std::size_t> rowOf(columns + 1), before(columns + 1);
    for (std::size_t row = 1; row <= rows; ++row) {
        rowOf[0] = row;
        std::size_t column = 0;
        std::vector<double> least(columns + 1, std::numeric_limits<double>::infinity());
        std::vector<bool> used(columns + 1, false);
        do {
            used[column] = true;
            const std::size_t at = rowOf[column];
            double step = std::numeric_limits<double>::infinity();
            std::size_t next = 0;
            for (std::size_t j = 1; j <= columns; ++j) {
                if (used[j]) continue;
                const double cost = costs[at - 1][j - 1] - ofRow[at] - ofColumn[j];
                if (cost < least[j]) {
                    least[j] = cost;
                    before[j] = column;
                }
                if (least[j] < step) {
                    step = least[j];
                    next = j;
                }
            }
            for (std::size_t j = 0; j <= columns; ++j) {
                if (used[j]) {
                    ofRow[rowOf[j]] += step;
                    ofColumn[j] -= step;
                } else {
                    least[j] -= step;
                }
            }
            column = next;
        } while (rowOf[column] != 0);
        for (; column != 0; column = before[column]) rowOf[column] = rowOf[before[column]];
    }
    std::vector<std::size_t> columnOf(rows);
    for (std::size_t j = 1; j <= columns; ++j) {
        if (rowOf[j] != 0) columnOf[rowOf[j] - 1] = j - 1;
    }
    return columnOf;
}

}  // namespace

FindsError compareFinds(std::span<const Eigen::Vector3d> finds, std::span<const Eigen::Vector3d> victims,
                        double reach) {
    FindsError error;
    error.finds = static_cast<int>(finds.size());
    // Extra columns are for finds without a victim.
    std::vector<std::vector<double>> costs(finds.size(),
                                           std::vector<double>(victims.size() + finds.size(), Apart));
    for (std::size_t i = 0; i < finds.size(); ++i) {
        for (std::size_t j = 0; j < victims.size(); ++j) {
            const double away = (finds[i] - victims[j]).head<2>().norm();
            if (away <= reach) costs[i][j] = away;
        }
    }
    const std::vector<std::size_t> columns = assigned(costs);
    for (std::size_t i = 0; i < finds.size(); ++i) {
        const double away = costs[i][columns[i]];
        if (away >= Apart) {
            ++error.wrong;
            continue;
        }
        error.mean += away;
        error.worst = std::max(error.worst, away);
    }
    if (error.found() > 0) error.mean /= error.found();
    error.missed = static_cast<int>(victims.size()) - error.found();
    return error;
}

}  // namespace leitstand
