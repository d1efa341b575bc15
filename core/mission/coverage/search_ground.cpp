#include "core/mission/coverage/search_ground.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/mapping/floor_heights.h"

namespace leitstand {
namespace {

constexpr int MostCells = 2000;       ///< along an axis
constexpr double Layer = 0.08;        ///< [m]
constexpr int Layers = 32;            ///< bits: up to 2.56 m
constexpr double MostExtent = 400.0;  ///< what is farther from the first scan is left out [m]
constexpr int Gap = 2;                ///< cells of floor that a sparse scan misses between others

template <class Take>
void forEachPoint(std::span<const ReportScan> scans, Take take) {
    if (scans.empty()) return;
    const Eigen::Vector3d first = scans.front().scanInMap.translation();
    for (const ReportScan& placed : scans) {
        if (!placed.scan) continue;
        for (std::size_t i = 0; i < placed.scan->points.size(); ++i) {
            const Eigen::Vector3d point = placed.scanInMap * placed.scan->points[i].cast<double>();
            if (!point.allFinite() || (point - first).cwiseAbs().maxCoeff() > MostExtent) continue;
            take(point, i < placed.scan->labels.size() ? placed.scan->labels[i] : Label::Unlabelled);
        }
    }
}

}  // namespace

std::ptrdiff_t SearchGround::cellAt(const Eigen::Vector2d& place) const {
    const double column = std::floor((place.x() - m_origin.x()) / m_cell),
                 row = std::floor((place.y() - m_origin.y()) / m_cell);
    if (!(column >= 0.0 && row >= 0.0 && column < m_columns && row < m_rows)) return -1;
    return static_cast<std::ptrdiff_t>(row) * m_columns + static_cast<std::ptrdiff_t>(column);
}

Eigen::Vector2d SearchGround::middleOf(std::size_t cell) const {
    const auto columns = static_cast<std::size_t>(m_columns);
    return m_origin + m_cell * Eigen::Vector2d(static_cast<double>(cell % columns) + 0.5,
                                               static_cast<double>(cell / columns) + 0.5);
}

double SearchGround::reachableArea() const {
    return m_cell * m_cell *
           static_cast<double>(std::count(m_reachable.begin(), m_reachable.end(), std::uint8_t{1}));
}

bool SearchGround::frame(std::span<const ReportScan> scans) {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    forEachPoint(scans, [&](const Eigen::Vector3d& point, Label) {
        low = low.cwiseMin(point.head<2>());
        high = high.cwiseMax(point.head<2>());
    });
    if (!(low.x() <= high.x())) return false;
    m_cell = m_settings.cell;
    while ((high - low).maxCoeff() / m_cell > MostCells) m_cell *= 2;
    m_origin = (low / m_cell).array().floor() * m_cell;
    m_columns = static_cast<int>((high.x() - m_origin.x()) / m_cell) + 1;
    m_rows = static_cast<int>((high.y() - m_origin.y()) / m_cell) + 1;
    const auto cells = static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows);
    m_height.assign(cells, 0.0F);
    m_standing.assign(cells, 0);
    m_floor.assign(cells, 0);
    m_reachable.assign(cells, 0);
    return true;
}

std::uint32_t SearchGround::layers(double low, double high) const {
    const int first = std::max(0, static_cast<int>(std::floor(low / Layer + 1e-6))),
              last = std::min(Layers - 1, static_cast<int>(std::floor(high / Layer + 1e-6)));
    std::uint32_t bits = 0;
    for (int layer = first; layer <= last; ++layer) bits |= std::uint32_t{1} << layer;
    return bits;
}

bool SearchGround::obstructs(std::size_t cell) const {
    return (m_standing[cell] & layers(m_settings.lowest, m_settings.robotHeight)) != 0;
}

/// Returns where robots were, in 16 parts of each cell (bit: 4 * row + column). The parts separate a robot
/// from a wall that it passes closely.
std::vector<std::uint16_t> SearchGround::trodden(std::span<const Eigen::Vector3d> trail) const {
    constexpr double Body = 0.27;  // of a robot about base_link [m]
    constexpr int Parts = 4;
    std::vector<std::uint16_t> parts(m_floor.size());
    const double step = m_cell / Parts;
    const int reach = static_cast<int>(Body / step) + 1;
    for (const Eigen::Vector3d& place : trail) {
        if (cellAt(place.head<2>()) < 0) continue;
        const Eigen::Vector2d at = (place.head<2>() - m_origin) / step;
        const int column = static_cast<int>(at.x()), row = static_cast<int>(at.y());
        for (int y = std::max(0, row - reach); y <= std::min(Parts * m_rows - 1, row + reach); ++y) {
            for (int x = std::max(0, column - reach); x <= std::min(Parts * m_columns - 1, column + reach);
                 ++x) {
                if (std::hypot(x + 0.5 - at.x(), y + 0.5 - at.y()) * step > Body) continue;
                const auto cell = static_cast<std::size_t>(y / Parts * m_columns + x / Parts);
                parts[cell] |= static_cast<std::uint16_t>(1U << (Parts * (y % Parts) + x % Parts));
            }
        }
    }
    return parts;
}

void SearchGround::stand(std::span<const ReportScan> scans, std::span<const Eigen::Vector3d> trail,
                         const FloorHeights& floor) {
    const std::vector<std::uint16_t> robots = trodden(trail);
    const std::uint32_t body = layers(0.0, m_settings.robotHeight);
    forEachPoint(scans, [&](const Eigen::Vector3d& point, Label label) {
        const auto found = cellAt(point.head<2>());
        if (found < 0 || label == Label::Ceiling) return;
        const auto cell = static_cast<std::size_t>(found);
        const double above = point.z() - static_cast<double>(m_height[cell]);
        if (!(above > m_settings.lowest && above < Layer * Layers)) return;
        const std::uint32_t layer = layers(above, above);
        if (robots[cell] != 0 && (layer & body) != 0) {
            // Robots that are seen where they drove, by themselves or by others, are no obstacles.
            const Eigen::Vector2d in =
                4.0 * ((point.head<2>() - m_origin) / m_cell).array().unaryExpr([](double at) {
                    return at - std::floor(at);
                });
            const int part =
                4 * std::min(3, static_cast<int>(in.y())) + std::min(3, static_cast<int>(in.x()));
            if ((robots[cell] >> part & 1U) != 0 && floor.seen(point.x(), point.y())) return;
        }
        m_standing[cell] |= layer;
    });
}

/// Closes gaps of one cell in walls of thinned scans: what stands on both sides of a cell also stands in it.
void SearchGround::closeWalls() {
    const std::vector<std::uint32_t> seen = m_standing;
    const auto at = [&](int x, int y) { return seen[static_cast<std::size_t>(y * m_columns + x)]; };
    for (int y = 1; y + 1 < m_rows; ++y) {
        for (int x = 1; x + 1 < m_columns; ++x) {
            const std::uint32_t across = (at(x - 1, y) & at(x + 1, y)) | (at(x, y - 1) & at(x, y + 1)),
                                aslant = (at(x - 1, y - 1) & at(x + 1, y + 1)) |
                                         (at(x - 1, y + 1) & at(x + 1, y - 1));
            m_standing[static_cast<std::size_t>(y * m_columns + x)] |= across | aslant;
        }
    }
}

/// Closes holes in the floor far from a scanner: along rows first, then along columns, so that holes in both
/// are closed.
void SearchGround::closeFloor() {
    const auto close = [this](int stepX, int stepY) {
        std::vector<std::uint8_t> whole = m_floor;
        const auto at = [&](int x, int y) {
            return x >= 0 && y >= 0 && x < m_columns && y < m_rows &&
                   m_floor[static_cast<std::size_t>(y * m_columns + x)] != 0;
        };
        for (int y = 0; y < m_rows; ++y) {
            for (int x = 0; x < m_columns; ++x) {
                const auto cell = static_cast<std::size_t>(y * m_columns + x);
                if (whole[cell] != 0 || obstructs(cell)) continue;
                bool before = false, after = false;
                for (int i = 1; i <= Gap; ++i) {
                    before = before || at(x - i * stepX, y - i * stepY);
                    after = after || at(x + i * stepX, y + i * stepY);
                }
                if (before && after) whole[cell] = 1;
            }
        }
        m_floor = std::move(whole);
    };
    close(1, 0);
    close(0, 1);
}

/// Returns @p cells and all cells within @p radius [m] of one.
std::vector<std::uint8_t> SearchGround::grown(const std::vector<std::uint8_t>& cells, double radius) const {
    std::vector<std::uint8_t> out(cells.size());
    const int reach = static_cast<int>(radius / m_cell);
    const double square = radius * radius / (m_cell * m_cell);
    for (int y = 0; y < m_rows; ++y) {
        for (int x = 0; x < m_columns; ++x) {
            if (cells[static_cast<std::size_t>(y * m_columns + x)] == 0) continue;
            for (int v = std::max(0, y - reach); v <= std::min(m_rows - 1, y + reach); ++v) {
                for (int u = std::max(0, x - reach); u <= std::min(m_columns - 1, x + reach); ++u) {
                    if ((u - x) * (u - x) + (v - y) * (v - y) <= square)
                        out[static_cast<std::size_t>(v * m_columns + u)] = 1;
                }
            }
        }
    }
    return out;
}

void SearchGround::reach(std::span<const Eigen::Vector3d> trail) {
    std::vector<std::uint8_t> obstacles(m_floor.size());
    for (std::size_t cell = 0; cell < obstacles.size(); ++cell) obstacles[cell] = obstructs(cell) ? 1 : 0;
    const std::vector<std::uint8_t> near = grown(obstacles, m_settings.robotRadius);
    std::vector<std::uint8_t> stood(m_floor.size());
    std::vector<std::size_t> open;
    const auto take = [&](std::size_t cell) {
        if (stood[cell] != 0) return;
        stood[cell] = 1;
        open.push_back(cell);
    };
    for (const Eigen::Vector3d& place : trail) {
        // The trail holds only places on this storey.
        if (const auto cell = cellAt(place.head<2>()); cell >= 0) take(static_cast<std::size_t>(cell));
    }
    // A scanner is blind close to its robot, so unseen cells there are no gaps. A robot can move where it
    // stands, however near things are.
    constexpr double Blind = 1.0, Body = 0.4;  // [m]
    const std::vector<std::uint8_t> blind = grown(stood, Blind), body = grown(stood, Body);
    constexpr double Step = 0.15;  // [m]
    for (std::size_t next = 0; next < open.size(); ++next) {
        const int row = static_cast<int>(open[next]) / m_columns,
                  column = static_cast<int>(open[next]) % m_columns;
        const auto spread = [&](int x, int y) {
            if (x < 0 || y < 0 || x >= m_columns || y >= m_rows) return;
            const auto cell = static_cast<std::size_t>(y * m_columns + x);
            if ((m_floor[cell] == 0 && blind[cell] == 0) || obstacles[cell] != 0) return;
            if (near[cell] != 0 && body[cell] == 0) return;
            if (std::abs(m_height[cell] - m_height[open[next]]) > static_cast<float>(Step)) return;
            take(cell);
        };
        spread(column - 1, row), spread(column + 1, row), spread(column, row - 1), spread(column, row + 1);
    }
    // What a robot stands on or touches is reachable.
    const std::vector<std::uint8_t> touched = grown(stood, m_settings.robotRadius + m_cell);
    for (std::size_t cell = 0; cell < touched.size(); ++cell)
        m_reachable[cell] = touched[cell] != 0 && m_floor[cell] != 0 ? 1 : 0;
}

SearchGround SearchGround::of(std::span<const ReportScan> scans, std::span<const Eigen::Vector3d> trail,
                              const CoverageSettings& settings, const StoreyHeights& heights) {
    SearchGround ground;
    ground.m_settings = settings;
    if (!ground.frame(scans)) return ground;
    std::vector<Eigen::Vector3d> here;
    std::copy_if(trail.begin(), trail.end(), std::back_inserter(here),
                 [&](const Eigen::Vector3d& place) { return heights.hold(place.z()); });
    FloorSettings how;
    how.cell = ground.m_cell;
    how.heights = heights;
    const FloorHeights floor = FloorHeights::of(scans, here, how);
    for (std::size_t cell = 0; cell < ground.size(); ++cell) {
        const Eigen::Vector2d place = ground.middleOf(cell);
        ground.m_height[cell] = static_cast<float>(floor.at(place.x(), place.y()));
    }
    ground.stand(scans, here, floor);
    ground.closeWalls();
    for (std::size_t cell = 0; cell < ground.size(); ++cell) {
        const Eigen::Vector2d place = ground.middleOf(cell);
        ground.m_floor[cell] = floor.seen(place.x(), place.y()) && !ground.obstructs(cell) ? 1 : 0;
    }
    ground.closeFloor();
    ground.reach(here);
    return ground;
}

bool SearchGround::hides(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    // Walks from cell to cell along the ray (Amanatides & Woo 1987), in units of cells.
    const Eigen::Vector2d begin = (from.head<2>() - m_origin) / m_cell,
                          end = (to.head<2>() - m_origin) / m_cell;
    const Eigen::Vector2d along = end - begin;
    int x = static_cast<int>(std::floor(begin.x())), y = static_cast<int>(std::floor(begin.y()));
    const int lastX = static_cast<int>(std::floor(end.x())), lastY = static_cast<int>(std::floor(end.y()));
    const int stepX = along.x() > 0 ? 1 : -1, stepY = along.y() > 0 ? 1 : -1;
    constexpr double Never = std::numeric_limits<double>::infinity();
    const double perX = along.x() == 0.0 ? Never : 1.0 / std::abs(along.x()),
                 perY = along.y() == 0.0 ? Never : 1.0 / std::abs(along.y());
    double nextX = perX == Never ? Never : perX * (stepX > 0 ? x + 1 - begin.x() : begin.x() - x),
           nextY = perY == Never ? Never : perY * (stepY > 0 ? y + 1 - begin.y() : begin.y() - y);
    double entered = 0.0;
    const double rise = to.z() - from.z();
    for (int guard = std::abs(lastX - x) + std::abs(lastY - y); guard >= 0; --guard) {
        const double left = std::min({nextX, nextY, 1.0});
        const bool ends = (x == lastX && y == lastY) || entered == 0.0;
        if (!ends && x >= 0 && y >= 0 && x < m_columns && y < m_rows) {
            const auto cell = static_cast<std::size_t>(y * m_columns + x);
            if (m_standing[cell] != 0) {
                const double floor = static_cast<double>(m_height[cell]),
                             in = from.z() + entered * rise - floor, out = from.z() + left * rise - floor;
                if (std::max(in, out) >= 0.0 &&
                    (m_standing[cell] & layers(std::min(in, out), std::max(in, out))) != 0)
                    return true;
            }
        }
        if (left >= 1.0) break;
        entered = left;
        if (nextX < nextY)
            x += stepX, nextX += perX;
        else
            y += stepY, nextY += perY;
    }
    return false;
}

}  // namespace leitstand
