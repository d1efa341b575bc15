#include "core/mapping/floor_heights.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace leitstand {
namespace {

constexpr float None = std::numeric_limits<float>::quiet_NaN();
constexpr int MostCells = 4000;  ///< along an axis

/// Calls @p take with every floor point of @p scans at @p heights, in the map [m].
template <class Take>
void forEachFloorPoint(std::span<const ReportScan> scans, const StoreyHeights& heights, Take take) {
    for (const ReportScan& placed : scans) {
        const Scan& scan = *placed.scan;
        for (std::size_t i = 0; i < scan.labels.size() && i < scan.points.size(); ++i) {
            if (scan.labels[i] != Label::Floor || !scan.points[i].allFinite()) continue;
            const Eigen::Vector3d point = placed.scanInMap * scan.points[i].cast<double>();
            if (heights.hold(point.z())) take(point);
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
    // Two passes over the points: they are many, and only their heights are kept.
    std::vector<std::uint32_t> ends(m_height.size() + 1);
    forEachFloorPoint(scans, settings.heights, [&](const Eigen::Vector3d& point) {
        const auto cell = cellOf(point.x(), point.y());
        if (cell >= 0) ++ends[static_cast<std::size_t>(cell) + 1];
    });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<float> heights(ends.back());
    std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
    forEachFloorPoint(scans, settings.heights, [&](const Eigen::Vector3d& point) {
        const auto cell = cellOf(point.x(), point.y());
        if (cell >= 0) heights[next[static_cast<std::size_t>(cell)]++] = static_cast<float>(point.z());
    });

    const auto layer = static_cast<float>(settings.layer), apart = static_cast<float>(settings.apart);
    m_first.push_back(0);
    for (std::size_t cell = 0; cell + 1 < ends.size(); ++cell) {
        const auto end = heights.begin() + ends[cell + 1];
        auto lowest = heights.begin() + ends[cell];
        std::sort(lowest, end);
        while (lowest != end) {
            const auto above = std::upper_bound(lowest, end, *lowest + layer);
            const double sum = std::accumulate(lowest, above, 0.0);
            m_surfaces.push_back(static_cast<float>(sum / static_cast<double>(above - lowest)));
            lowest = std::upper_bound(above, end, *lowest + apart);
        }
        m_first.push_back(static_cast<std::uint32_t>(m_surfaces.size()));
    }
    m_reached.assign(m_surfaces.size(), 0);
}

double FloorHeights::grow(std::span<const Eigen::Vector3d> ground, const FloorSettings& settings) {
    struct Reached {
        std::size_t cell;
        float height;
    };
    std::vector<Reached> open;
    /// Takes the surfaces of a cell that are so near to a height; or only its lowest one, if it is.
    const auto take = [&](std::size_t cell, double height, double within, bool lowest = false) {
        for (std::size_t i = m_first[cell]; i < m_first[cell + 1]; ++i) {
            if (m_reached[i] == 0 && std::abs(m_surfaces[i] - height) < within) {
                m_reached[i] = 1;
                open.push_back({cell, m_surfaces[i]});
            }
            if (lowest) return;
        }
    };
    // A scanner is blind close to its robot: the floor that it sees begins at a distance.
    const int blind = static_cast<int>(settings.blind / m_cell);
    for (const Eigen::Vector3d& point : ground) {
        for (int y = -blind; y <= blind; ++y) {
            for (int x = -blind; x <= blind; ++x) {
                if (x * x + y * y > blind * blind) continue;
                const auto cell = cellOf(point.x() + x * m_cell, point.y() + y * m_cell);
                // Beside the robot there may be a pallet.
                const double within = x == 0 && y == 0 ? settings.underRobot : settings.step;
                if (cell >= 0) take(static_cast<std::size_t>(cell), point.z(), within);
            }
        }
    }
    double lift = 0.0;
    if (open.empty()) {
        // A robot whose base_link is not on the ground, or whose scanner has no known mount.
        for (const Eigen::Vector3d& point : ground) {
            const auto cell = cellOf(point.x(), point.y());
            const std::size_t before = open.size();
            if (cell >= 0) take(static_cast<std::size_t>(cell), point.z(), 2.0, true);
            if (open.size() > before) lift += point.z() - static_cast<double>(open.back().height);
        }
        if (!open.empty()) lift /= static_cast<double>(open.size());
    }
    if (const auto low = std::min_element(m_surfaces.begin(), m_surfaces.end());
        open.empty() && low != m_surfaces.end()) {
        const auto cell = std::upper_bound(m_first.begin(), m_first.end(),
                                           static_cast<std::uint32_t>(low - m_surfaces.begin()));
        take(static_cast<std::size_t>(cell - m_first.begin()) - 1, static_cast<double>(*low), 1e-3);
    }
    constexpr int Reach = 2;  // sparse floors far from the scanner have holes
    for (std::size_t next = 0; next < open.size(); ++next) {
        const auto [from, height] = open[next];
        const int row = static_cast<int>(from) / m_columns, column = static_cast<int>(from) % m_columns;
        for (int y = std::max(0, row - Reach); y <= std::min(m_rows - 1, row + Reach); ++y) {
            for (int x = std::max(0, column - Reach); x <= std::min(m_columns - 1, column + Reach); ++x)
                take(static_cast<std::size_t>(y * m_columns + x), static_cast<double>(height), settings.step);
        }
    }
    return lift;
}

/// Chooses, of the surfaces of a cell that can be reached, the one that robots are on.
void FloorHeights::choose(std::span<const Eigen::Vector3d> ground, double lift) {
    std::vector<float> driven(m_height.size(), None);
    for (const Eigen::Vector3d& point : ground) {
        const auto cell = cellOf(point.x(), point.y());
        if (cell < 0) continue;
        float& height = driven[static_cast<std::size_t>(cell)];
        height = std::fmin(height, static_cast<float>(point.z() - lift));
    }
    fill(driven);
    for (std::size_t cell = 0; cell < m_height.size(); ++cell) {
        for (std::size_t i = m_first[cell]; i < m_first[cell + 1]; ++i) {
            if (m_reached[i] == 0) continue;
            const bool nearer =
                std::abs(m_surfaces[i] - driven[cell]) < std::abs(m_height[cell] - driven[cell]);
            if (m_seen[cell] == 0 || nearer) m_height[cell] = m_surfaces[i];
            m_seen[cell] = 1;
        }
    }
}

/// Takes the lowest height of robots in a cell for its floor, which nobody saw.
void FloorHeights::follow(std::span<const Eigen::Vector3d> ground) {
    for (const Eigen::Vector3d& place : ground) {
        const auto cell = cellOf(place.x(), place.y());
        if (cell < 0) continue;
        float& height = m_height[static_cast<std::size_t>(cell)];
        height = std::fmin(height, static_cast<float>(place.z()));
    }
}

/// Fills unknown heights from the nearest cell with a known one.
void FloorHeights::fill(std::vector<float>& heights) const {
    std::vector<std::size_t> open;
    for (std::size_t cell = 0; cell < heights.size(); ++cell) {
        if (!std::isnan(heights[cell])) open.push_back(cell);
    }
    for (std::size_t next = 0; next < open.size(); ++next) {
        const int row = static_cast<int>(open[next]) / m_columns,
                  column = static_cast<int>(open[next]) % m_columns;
        const auto spread = [&](int x, int y) {
            if (x < 0 || y < 0 || x >= m_columns || y >= m_rows) return;
            const auto cell = static_cast<std::size_t>(y * m_columns + x);
            if (!std::isnan(heights[cell])) return;
            heights[cell] = heights[open[next]];
            open.push_back(cell);
        };
        spread(column - 1, row), spread(column + 1, row), spread(column, row - 1), spread(column, row + 1);
    }
}

FloorHeights FloorHeights::of(std::span<const ReportScan> scans, std::span<const Eigen::Vector3d> trail,
                              const FloorSettings& settings) {
    std::vector<Eigen::Vector3d> ground;
    std::copy_if(trail.begin(), trail.end(), std::back_inserter(ground),
                 [&](const Eigen::Vector3d& place) { return settings.heights.hold(place.z()); });
    FloorHeights floor;
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    forEachFloorPoint(scans, settings.heights, [&](const Eigen::Vector3d& point) {
        low = low.cwiseMin(point.head<2>());
        high = high.cwiseMax(point.head<2>());
    });
    if (!(low.x() <= high.x())) {  // no scanner sees floor: it is where robots drove
        for (const Eigen::Vector3d& place : ground) {
            low = low.cwiseMin(place.head<2>());
            high = high.cwiseMax(place.head<2>());
        }
    }
    if (!(low.x() <= high.x()) || !low.allFinite() || !high.allFinite()) return floor;
    floor.m_cell = settings.cell;
    const double extent = (high - low).maxCoeff();
    while (extent / floor.m_cell > MostCells) floor.m_cell *= 2;
    floor.m_origin = low;
    floor.m_columns = static_cast<int>((high.x() - low.x()) / floor.m_cell) + 1;
    floor.m_rows = static_cast<int>((high.y() - low.y()) / floor.m_cell) + 1;
    const auto cells = static_cast<std::size_t>(floor.m_columns) * static_cast<std::size_t>(floor.m_rows);
    floor.m_height.assign(cells, None);
    floor.m_seen.assign(cells, 0);
    floor.gather(scans, settings);
    if (floor.m_surfaces.empty()) {
        floor.follow(ground);
    } else {
        floor.choose(ground, floor.grow(ground, settings));
    }
    floor.fill(floor.m_height);
    return floor;
}

double FloorHeights::at(double x, double y) const {
    if (m_height.empty() || !std::isfinite(x) || !std::isfinite(y)) return 0.0;
    const double column = std::clamp(std::floor((x - m_origin.x()) / m_cell), 0.0, m_columns - 1.0),
                 row = std::clamp(std::floor((y - m_origin.y()) / m_cell), 0.0, m_rows - 1.0);
    const float height = m_height[static_cast<std::size_t>(row * m_columns + column)];
    return std::isnan(height) ? 0.0 : static_cast<double>(height);
}

double FloorHeights::below(const Eigen::Vector3d& place) const {
    constexpr double About = 0.15;  // accuracy of places [m]
    constexpr int Reach = 5;        // an object hides the floor around it
    double nearest = std::numeric_limits<double>::infinity(), height = at(place.x(), place.y());
    for (int y = -Reach; y <= Reach; ++y) {
        for (int x = -Reach; x <= Reach; ++x) {
            const auto cell = cellOf(place.x() + x * m_cell, place.y() + y * m_cell);
            if (cell < 0 || x * x + y * y >= nearest) continue;
            for (std::size_t i = m_first[static_cast<std::size_t>(cell)];
                 i < m_first[static_cast<std::size_t>(cell) + 1]; ++i) {
                if (m_reached[i] == 0 || m_surfaces[i] > place.z() + About) continue;
                height = static_cast<double>(m_surfaces[i]);
                nearest = x * x + y * y;
            }
        }
    }
    return height;
}

bool FloorHeights::seen(double x, double y) const {
    const auto cell = cellOf(x, y);
    return cell >= 0 && m_seen[static_cast<std::size_t>(cell)] != 0;
}

}  // namespace leitstand
