#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "robots/simulation/arena/random.h"

namespace leitstand::simulation {

/// A square of a maze.
struct Cell {
    int column = 0, row = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
};

/// Sides of a cell. The y axis of a side's frame points to that side.
enum class Side : std::uint8_t { North, West, South, East };
inline constexpr int SideCount = 4;
[[nodiscard]] Cell beyond(const Cell& cell, Side side);
[[nodiscard]] Side opposite(Side side);

/// What stands between two cells.
enum class Border : std::uint8_t { Wall, Open, Door, Curtain };

/// A grid of cells with walls between them. At first all cells are closed.
class Maze {
public:
    Maze(int columns, int rows);

    [[nodiscard]] int columns() const { return m_columns; }
    [[nodiscard]] int rows() const { return m_rows; }
    [[nodiscard]] bool has(const Cell& cell) const;
    [[nodiscard]] Border border(const Cell& cell, Side side) const;
    void setBorder(const Cell& cell, Side side, Border border);

    /// Opens walls between cells that @p among accepts, until there is exactly one way from @p first to each
    /// of them.
    void carve(Random& random, const Cell& first, const std::function<bool(const Cell&)>& among);
    /// Opens each remaining wall between cells that @p among accepts with the probability @p probability.
    /// This makes loops.
    void loosen(Random& random, double probability, const std::function<bool(const Cell&)>& among);
    /// Returns whether all cells are still connected if @p cell has a wall at @p side. Curtains are treated
    /// as walls.
    [[nodiscard]] bool connectedWithout(const Cell& cell, Side side) const;

private:
    [[nodiscard]] std::size_t place(const Cell& cell, Side side) const;

    int m_columns, m_rows;
    /// Southern and western border of each cell, with one more row and column.
    std::vector<Border> m_south, m_west;
};

}  // namespace leitstand::simulation
