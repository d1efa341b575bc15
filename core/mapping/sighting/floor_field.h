#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace leitstand {

/// A square of the map around a place, divided into cells.
class SquareGrid {
public:
    /// The square reaches @p reach [m] to each side of @p middle. @p edge: edge of a cell [m].
    SquareGrid(const Eigen::Vector2d& middle, double reach, double edge);

    /// Returns the cell of @p point; empty: outside the square.
    [[nodiscard]] std::optional<std::size_t> cellOf(const Eigen::Vector2d& point) const;
    [[nodiscard]] std::size_t cells() const { return m_size * m_size; }
    /// Calls @p what with @p cell and the cells around it.
    template <class What>
    void about(std::size_t cell, What what) const {
        const std::size_t x = cell % m_size, y = cell / m_size;
        for (std::size_t v = y == 0 ? 0 : y - 1; v <= y + 1 && v < m_size; ++v) {
            for (std::size_t u = x == 0 ? 0 : x - 1; u <= x + 1 && u < m_size; ++u) what(v * m_size + u);
        }
    }

private:
    Eigen::Vector2d m_from;
    double m_edge;
    std::size_t m_size;
};

/// The height of the floor around a place, computed from its low points. Also works on ramps, and where a
/// body hides the floor.
class FloorField {
public:
    /// @p points: in the map [m].
    FloorField(const SquareGrid& grid, std::span<const Eigen::Vector3f> points);

    /// Returns the floor's height in the map [m]; empty: unknown.
    [[nodiscard]] std::optional<double> heightAt(const Eigen::Vector2d& point) const;

private:
    SquareGrid m_grid;
    std::vector<float> m_heights;  ///< by cell; NaN: unknown
};

}  // namespace leitstand
