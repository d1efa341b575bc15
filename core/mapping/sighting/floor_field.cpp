#include "core/mapping/sighting/floor_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/unknown.h"

namespace leitstand {
namespace {

constexpr double Low = 0.2;     ///< share of a cell's points that may lie below its floor, as noise
constexpr float Steep = 0.15F;  ///< largest rise of a floor from a cell to the next [m]
constexpr float NoHeight = std::numeric_limits<float>::quiet_NaN();

float lowOf(std::vector<float>& heights) {
    if (heights.empty()) return NoHeight;
    const auto place =
        heights.begin() + static_cast<std::ptrdiff_t>(Low * static_cast<double>(heights.size()));
    std::nth_element(heights.begin(), place, heights.end());
    return *place;
}

}  // namespace

SquareGrid::SquareGrid(const Eigen::Vector2d& middle, double reach, double edge)
    : m_from(middle.array() - reach),
      m_edge(edge),
      m_size(static_cast<std::size_t>(std::ceil(2.0 * reach / edge))) {}

std::optional<std::size_t> SquareGrid::cellOf(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d at = (point - m_from) / m_edge;
    const auto size = static_cast<double>(m_size);
    if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < size && at.y() < size)) return std::nullopt;
    return static_cast<std::size_t>(at.y()) * m_size + static_cast<std::size_t>(at.x());
}

FloorField::FloorField(const SquareGrid& grid, std::span<const Eigen::Vector3f> points) : m_grid(grid) {
    std::vector<std::vector<float>> heights(grid.cells());
    for (const Eigen::Vector3f& point : points) {
        if (const auto cell = grid.cellOf(point.head<2>().cast<double>()))
            heights[*cell].push_back(point.z());
    }
    std::vector<float> own;
    for (auto& of : heights) own.push_back(lowOf(of));
    for (std::size_t i = 0; i < own.size(); ++i) {
        float about = NoHeight;
        grid.about(i, [&](std::size_t other) { about = std::fmin(about, own[other]); });
        // A cell that stands so high over all its neighbours is no floor.
        m_heights.push_back(own[i] < about + Steep ? own[i] : about);
    }
}

std::optional<double> FloorField::heightAt(const Eigen::Vector2d& point) const {
    const auto cell = m_grid.cellOf(point);
    if (!cell || std::isnan(m_heights[*cell])) return std::nullopt;
    return double{m_heights[*cell]};
}

}  // namespace leitstand
