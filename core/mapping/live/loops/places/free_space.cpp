#include "core/mapping/live/loops/places/free_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace leitstand {
namespace {

constexpr float Pi = std::numbers::pi_v<float>;
constexpr int Columns = 180, Rows = 90;  ///< of two degrees: azimuth, elevation
constexpr float Border = 0.35F;          ///< of a cell's edge: so near to a border the neighbour counts, too
/// The place of a direction in the grid, in cells.
struct GridPlace {
    float column, row;
};

GridPlace placeOf(const Eigen::Vector3f& direction) {
    const float turn = std::atan2(direction.y(), direction.x()) / (2.0F * Pi) + 0.5F;
    const float up = std::asin(std::clamp(direction.z() / direction.norm(), -1.0F, 1.0F));
    return {turn * Columns, (up / Pi + 0.5F) * Rows};
}

std::size_t cellAt(float column, float row) {
    const int j = (static_cast<int>(std::floor(column)) + Columns) % Columns;
    const int i = std::clamp(static_cast<int>(std::floor(row)), 0, Rows - 1);
    return static_cast<std::size_t>(i * Columns + j);
}

}  // namespace

double FreeSpaceFit::filledShare() const {
    const std::size_t judged = agreed + filled;
    return judged == 0 ? 0.0 : static_cast<double>(filled) / static_cast<double>(judged);
}

std::size_t FreeSpace::cellOf(const Eigen::Vector3f& direction) {
    const GridPlace place = placeOf(direction);
    return cellAt(place.column, place.row);
}

FreeSpace::FreeSpace(std::span<const Eigen::Vector3f> points, const FreeSpaceSettings& settings)
    : m_settings(settings), m_cells(static_cast<std::size_t>(Columns) * Rows) {
    std::vector<Cell> seen(m_cells.size());
    for (const Eigen::Vector3f& point : points) {
        const float range = point.norm();
        if (!(range > 0.0F)) continue;
        Cell& cell = seen[cellOf(point)];
        cell.nearest = cell.nearest == 0.0F ? range : std::min(cell.nearest, range);
        cell.farthest = std::max(cell.farthest, range);
        ++cell.rays;
    }
    if (!settings.beside) {
        m_cells = std::move(seen);
        return;
    }
    for (int row = 0; row < Rows; ++row) {
        for (int column = 0; column < Columns; ++column) {
            Cell& cell = m_cells[static_cast<std::size_t>(row * Columns + column)];
            cell.rays = seen[static_cast<std::size_t>(row * Columns + column)].rays;
            for (int i = std::max(0, row - 1); i <= std::min(Rows - 1, row + 1); ++i) {
                for (int j = column - 1; j <= column + 1; ++j) {
                    const int around = (j + Columns) % Columns;
                    const Cell& other = seen[static_cast<std::size_t>(i * Columns + around)];
                    if (other.nearest == 0.0F) continue;
                    cell.nearest =
                        cell.nearest == 0.0F ? other.nearest : std::min(cell.nearest, other.nearest);
                    cell.farthest = std::max(cell.farthest, other.farthest);
                }
            }
        }
    }
}

FreeSpaceFit FreeSpace::fit(std::span<const Eigen::Vector3f> points, const Pose& pose) const {
    const Eigen::Isometry3f placed = pose.cast<float>();
    FreeSpaceFit fit;
    for (const Eigen::Vector3f& point : points) {
        const Eigen::Vector3f there = placed * point;
        const float range = there.norm();
        if (!(range > m_settings.nearest)) continue;
        const Cell& cell = m_cells[cellOf(there)];
        if (cell.nearest == 0.0F) continue;
        const float margin = m_settings.margin + m_settings.marginOfRange * range;
        if (range < cell.nearest - margin)
            ++fit.filled;
        else if (range < cell.farthest + margin)
            ++fit.agreed;
    }
    return fit;
}

SeenThere FreeSpace::at(const Eigen::Vector3f& place) const {
    const float range = place.norm();
    if (!(range > m_settings.nearest)) return SeenThere::Unknown;
    const GridPlace middle = placeOf(place);
    const float border = m_settings.beside ? 0.0F : Border;
    Cell seen;
    for (const float across : {-border, border}) {
        for (const float up : {-border, border}) {
            const Cell& cell = m_cells[cellAt(middle.column + across, middle.row + up)];
            if (cell.nearest == 0.0F || cell.rays < m_settings.rays) return SeenThere::Unknown;
            seen.nearest = seen.nearest == 0.0F ? cell.nearest : std::min(seen.nearest, cell.nearest);
            seen.farthest = std::max(seen.farthest, cell.farthest);
        }
    }
    const float margin = m_settings.margin + m_settings.marginOfRange * range;
    if (range < seen.nearest - margin) return SeenThere::LookedThrough;
    const bool about = range < seen.farthest + margin && seen.farthest - seen.nearest < 2.0F * margin;
    return about ? SeenThere::Surface : SeenThere::Unknown;
}

double filledShare(const Scan& first, const Scan& second, const Pose& secondInFirst) {
    return std::max(FreeSpace(first.points).fit(second.points, secondInFirst).filledShare(),
                    FreeSpace(second.points).fit(first.points, secondInFirst.inverse()).filledShare());
}

}  // namespace leitstand
