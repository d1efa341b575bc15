#include "core/perception/surroundings/own_body_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr double Cell = degrees(2.0);  // as wide as a turning scanner's steps
constexpr int Columns = 180, Rows = 90;
constexpr auto Memory = std::chrono::seconds(20);  // cameras on pan-tilt units move

struct Place {
    int column, row;
};

Place placeOf(const Eigen::Vector3d& direction) {
    const double azimuth = std::atan2(direction.y(), direction.x());
    const double elevation = std::atan2(direction.z(), direction.head<2>().norm());
    const int column = static_cast<int>(std::floor(azimuth / Cell)) + Columns / 2;
    const int row = static_cast<int>(std::floor(elevation / Cell)) + Rows / 2;
    return {std::clamp(column, 0, Columns - 1), std::clamp(row, 0, Rows - 1)};
}

std::size_t indexOf(int column, int row) {
    return static_cast<std::size_t>(row * Columns + (column + Columns) % Columns);
}

}  // namespace

void OwnBodyMask::add(const Eigen::Vector3d& direction, Time at) {
    if (m_metAt.empty()) m_metAt.resize(static_cast<std::size_t>(Columns) * Rows);
    const Place place = placeOf(direction);
    m_metAt[indexOf(place.column, place.row)] = at;
}

bool OwnBodyMask::isNear(const Eigen::Vector3d& direction, Time at) const {
    if (m_metAt.empty()) return false;
    const Place place = placeOf(direction);
    for (int row = std::max(0, place.row - 1); row <= std::min(Rows - 1, place.row + 1); ++row) {
        for (int column = place.column - 1; column <= place.column + 1; ++column) {
            const auto& met = m_metAt[indexOf(column, row)];
            if (met && at - *met < Memory) return true;
        }
    }
    return false;
}

}  // namespace leitstand
