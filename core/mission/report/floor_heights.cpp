#include "core/mission/report/floor_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leitstand {
namespace {

constexpr float None = std::numeric_limits<float>::quiet_NaN();
constexpr int MostCells = 4000;  ///< along an axis

/// Calls @p take with every floor point of @p scans in the map [m].
template <class Take>
void forEachFloorPoint(std::span<const ReportScan> scans, Take take) {
    for (const ReportScan& placed : scans) {
        const Scan& scan = *placed.scan;
        for (std::size_t i = 0; i < scan.labels.size() && i < scan.points.size(); ++i) {
            if (scan.labels[i] == Label::Floor && scan.points[i].allFinite())
                take(placed.scanInMap * scan.points[i].cast<double>());
        }
    }
}

}  // namespace

std::ptrdiff_t FloorHeights::cellOf(double x, double y) const {
    const double column = std::floor((x - m_origin.x()) / m_cell),
                 row = std::floor((y - m_origin.y()) / m_cell);
    if (!(column >= 0.0 && row >= 0.0 && column < m_columns && row < m_rows)) return -1;
    return static_cast<std::ptrdiff_t>(row) * m_columns + static_cast<std::ptrdiff_t>(column);
}

void FloorHeights::gather(std::span<const ReportScan> scans, const FloorSettings& settings) {
    std::vector<float> lowest(m_surface.size(), std::numeric_limits<float>::infinity());
    forEachFloorPoint(scans, [&](const Eigen::Vector3d& point) {
        if (const auto cell = cellOf(point.x(), point.y()); cell >= 0) {
            float& low = lowest[static_cast<std::size_t>(cell)];
            low = std::min(low, static_cast<float>(point.z()));
        }
    });
    std::vector<double> sums(m_surface.size());
    std::vector<std::uint32_t> counts(m_surface.size());
    forEachFloorPoint(scans, [&](const Eigen::Vector3d& point) {
        const auto found = cellOf(point.x(), point.y());
        if (found < 0) return;
        const auto cell = static_cast<std::size_t>(found);
        if (point.z() > lowest[cell] + settings.layer) return;
        sums[cell] += point.z();
        ++counts[cell];
    });
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        if (counts[cell] > 0) m_surface[cell] = static_cast<float>(sums[cell] / counts[cell]);
    }
}

void FloorHeights::grow(std::span<const Eigen::Vector3d> ground, const FloorSettings& settings) {
    std::vector<std::size_t> open;
    const auto take = [&](std::size_t cell) {
        m_height[cell] = m_surface[cell];
        m_seen[cell] = 1;
        open.push_back(cell);
    };
    const auto seed = [&](double within) {
        for (const Eigen::Vector3d& point : ground) {
            const auto found = cellOf(point.x(), point.y());
            if (found < 0) continue;
            const auto cell = static_cast<std::size_t>(found);
            if (m_seen[cell] == 0 && std::abs(m_surface[cell] - point.z()) < within) take(cell);
        }
    };
    // A scanner is blind close to its robot: the floor that it sees begins some way off.
    const int blind = static_cast<int>(settings.blind / m_cell);
    for (const Eigen::Vector3d& point : ground) {
        for (int y = -blind; y <= blind; ++y) {
            for (int x = -blind; x <= blind; ++x) {
                if (x * x + y * y > blind * blind) continue;
                const auto found = cellOf(point.x() + x * m_cell, point.y() + y * m_cell);
                if (found < 0) continue;
                const auto cell = static_cast<std::size_t>(found);
                // Beside it there may be a pallet.
                const double within = x == 0 && y == 0 ? settings.underRobot : settings.step;
                if (m_seen[cell] == 0 && std::abs(m_surface[cell] - point.z()) < within) take(cell);
            }
        }
    }
    // A robot whose base_link is not on the ground, or of which nobody tells where its scanner sits.
    if (open.empty()) seed(2.0);
    if (open.empty()) {
        const auto low = std::min_element(m_surface.begin(), m_surface.end(), [](float a, float b) {
            return !std::isnan(a) && (std::isnan(b) || a < b);
        });
        if (low != m_surface.end() && !std::isnan(*low))
            take(static_cast<std::size_t>(low - m_surface.begin()));
    }
    constexpr int Reach = 2;  // sparse floors far from the scanner have holes
    for (std::size_t next = 0; next < open.size(); ++next) {
        const int row = static_cast<int>(open[next]) / m_columns,
                  column = static_cast<int>(open[next]) % m_columns;
        for (int y = std::max(0, row - Reach); y <= std::min(m_rows - 1, row + Reach); ++y) {
            for (int x = std::max(0, column - Reach); x <= std::min(m_columns - 1, column + Reach); ++x) {
                const auto cell = static_cast<std::size_t>(y * m_columns + x);
                if (m_seen[cell] != 0) continue;
                if (std::abs(m_surface[cell] - m_height[open[next]]) < settings.step) take(cell);
            }
        }
    }
}

/// Where no floor is known: as at the nearest cell where it is.
void FloorHeights::fill() {
    std::vector<std::size_t> open;
    for (std::size_t cell = 0; cell < m_height.size(); ++cell) {
        if (m_seen[cell] != 0) open.push_back(cell);
    }
    for (std::size_t next = 0; next < open.size(); ++next) {
        const int row = static_cast<int>(open[next]) / m_columns,
                  column = static_cast<int>(open[next]) % m_columns;
        const auto spread = [&](int x, int y) {
            if (x < 0 || y < 0 || x >= m_columns || y >= m_rows) return;
            const auto cell = static_cast<std::size_t>(y * m_columns + x);
            if (!std::isnan(m_height[cell])) return;
            m_height[cell] = m_height[open[next]];
            open.push_back(cell);
        };
        spread(column - 1, row), spread(column + 1, row), spread(column, row - 1), spread(column, row + 1);
    }
}

FloorHeights FloorHeights::of(std::span<const ReportScan> scans, std::span<const Eigen::Vector3d> ground,
                              const FloorSettings& settings) {
    FloorHeights floor;
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    forEachFloorPoint(scans, [&](const Eigen::Vector3d& point) {
        low = low.cwiseMin(point.head<2>());
        high = high.cwiseMax(point.head<2>());
    });
    if (!(low.x() <= high.x()) || !low.allFinite() || !high.allFinite()) return floor;
    floor.m_cell = settings.cell;
    const double extent = (high - low).maxCoeff();
    while (extent / floor.m_cell > MostCells) floor.m_cell *= 2;
    floor.m_origin = low;
    floor.m_columns = static_cast<int>((high.x() - low.x()) / floor.m_cell) + 1;
    floor.m_rows = static_cast<int>((high.y() - low.y()) / floor.m_cell) + 1;
    const auto cells = static_cast<std::size_t>(floor.m_columns) * static_cast<std::size_t>(floor.m_rows);
    floor.m_surface.assign(cells, None);
    floor.m_height.assign(cells, None);
    floor.m_seen.assign(cells, 0);
    floor.gather(scans, settings);
    floor.grow(ground, settings);
    floor.fill();
    return floor;
}

double FloorHeights::at(double x, double y) const {
    if (m_height.empty()) return 0.0;
    const double column = std::clamp(std::floor((x - m_origin.x()) / m_cell), 0.0, m_columns - 1.0),
                 row = std::clamp(std::floor((y - m_origin.y()) / m_cell), 0.0, m_rows - 1.0);
    const float height = m_height[static_cast<std::size_t>(row * m_columns + column)];
    return std::isnan(height) ? 0.0 : static_cast<double>(height);
}

bool FloorHeights::seen(double x, double y) const {
    const auto cell = cellOf(x, y);
    return cell >= 0 && m_seen[static_cast<std::size_t>(cell)] != 0;
}

}  // namespace leitstand
