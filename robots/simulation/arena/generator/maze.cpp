#include "robots/simulation/arena/generator/maze.h"

#include <algorithm>
#include <cassert>

namespace leitstand::simulation {

Cell beyond(const Cell& cell, Side side) {
    switch (side) {
        case Side::North:
            return {cell.column, cell.row + 1};
        case Side::West:
            return {cell.column - 1, cell.row};
        case Side::South:
            return {cell.column, cell.row - 1};
        case Side::East:
            break;
    }
    return {cell.column + 1, cell.row};
}

Side opposite(Side side) {
    return static_cast<Side>((static_cast<int>(side) + 2) % SideCount);
}

Maze::Maze(int columns, int rows)
    : m_columns(columns),
      m_rows(rows),
      m_south(static_cast<std::size_t>((columns + 1) * (rows + 1)), Border::Wall),
      m_west(m_south.size(), Border::Wall) {}

bool Maze::has(const Cell& cell) const {
    return cell.column >= 0 && cell.row >= 0 && cell.column < m_columns && cell.row < m_rows;
}

std::size_t Maze::place(const Cell& cell, Side side) const {
    const int column = cell.column + (side == Side::East ? 1 : 0);
    const int row = cell.row + (side == Side::North ? 1 : 0);
    assert(column >= 0 && row >= 0 && column <= m_columns && row <= m_rows);
    return static_cast<std::size_t>(row * (m_columns + 1) + column);
}

Border Maze::border(const Cell& cell, Side side) const {
    const bool level = side == Side::North || side == Side::South;
    return (level ? m_south : m_west)[place(cell, side)];
}

void Maze::setBorder(const Cell& cell, Side side, Border border) {
    const bool level = side == Side::North || side == Side::South;
    (level ? m_south : m_west)[place(cell, side)] = border;
}

void Maze::carve(Random& random, const Cell& first, const std::function<bool(const Cell&)>& among) {
    std::vector<char> seen(static_cast<std::size_t>(m_columns * m_rows), 0);
    const auto mark = [&](const Cell& cell) -> char& {
        return seen[static_cast<std::size_t>(cell.row * m_columns + cell.column)];
    };
    std::vector<Cell> way = {first};
    mark(first) = 1;
    while (!way.empty()) {
        std::vector<Side> sides;
        for (int i = 0; i < SideCount; ++i) {
            const Cell next = beyond(way.back(), static_cast<Side>(i));
            if (has(next) && among(next) && mark(next) == 0) sides.push_back(static_cast<Side>(i));
        }
        if (sides.empty()) {
            way.pop_back();
            continue;
        }
        const Side side = sides[static_cast<std::size_t>(random.below(static_cast<int>(sides.size())))];
        setBorder(way.back(), side, Border::Open);
        way.push_back(beyond(way.back(), side));
        mark(way.back()) = 1;
    }
}

void Maze::loosen(Random& random, double probability, const std::function<bool(const Cell&)>& among) {
    for (int row = 0; row < m_rows; ++row) {
        for (int column = 0; column < m_columns; ++column) {
            for (const Side side : {Side::North, Side::East}) {
                const Cell cell{column, row};
                const Cell next = beyond(cell, side);
                if (!has(next) || !among(cell) || !among(next) || border(cell, side) != Border::Wall)
                    continue;
                if (random.chance(probability)) setBorder(cell, side, Border::Open);
            }
        }
    }
}

bool Maze::connectedWithout(const Cell& cell, Side side) const {
    std::vector<char> seen(static_cast<std::size_t>(m_columns * m_rows), 0);
    std::vector<Cell> open = {cell};
    seen[static_cast<std::size_t>(cell.row * m_columns + cell.column)] = 1;
    while (!open.empty()) {
        const Cell at = open.back();
        open.pop_back();
        for (int i = 0; i < SideCount; ++i) {
            const Side way = static_cast<Side>(i);
            const Cell next = beyond(at, way);
            const bool closed = (at == cell && way == side) || (next == cell && way == opposite(side));
            const Border between = border(at, way);
            if (!has(next) || closed || between == Border::Wall || between == Border::Curtain) continue;
            char& mark = seen[static_cast<std::size_t>(next.row * m_columns + next.column)];
            if (mark == 0) open.push_back(next);
            mark = 1;
        }
    }
    return std::find(seen.begin(), seen.end(), 0) == seen.end();
}

}  // namespace leitstand::simulation
