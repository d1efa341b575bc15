#include "robots/simulation/arena/generator/plan.h"

#include <cmath>

#include <fmt/format.h>

namespace leitstand::simulation {

Plan::Plan(Grade grade, std::uint64_t seed, std::uint64_t attempt)
    : random(seed * 0x9E3779B97F4A7C15ULL + 1000003ULL * attempt +
             static_cast<std::uint64_t>(grade) * 7919ULL),
      maze(MazeEdge, MazeEdge) {
    arena.name = fmt::format("{} {}", toString(grade), seed);
    arena.grade = grade;
    arena.seed = seed;
    arena.to = Eigen::Vector2d::Constant(rounded(MazeEdge * CellEdge));
    arena.light = rounded(random.between(0.55, 0.9));
}

double Plan::rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

Eigen::Vector3d Plan::middle(const Cell& cell) {
    return {rounded((cell.column + 0.5) * CellEdge), rounded((cell.row + 0.5) * CellEdge), level(cell)};
}

Pose Plan::upright(const Eigen::Vector3d& position, double inDegrees) {
    return poseFrom(position.unaryExpr(&Plan::rounded), 0.0, 0.0,
                    degrees(std::round(inDegrees * 10.0) / 10.0));
}

Pose Plan::before(const Cell& cell, Side side, double distance, double along, double up) {
    static constexpr std::array<std::array<int, 2>, SideCount> Towards = {{{0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
    const auto& [tx, ty] = Towards[static_cast<std::size_t>(side)];
    const double reach = CellEdge / 2 - WallThickness / 2 - distance;
    const Eigen::Vector3d at =
        middle(cell) + Eigen::Vector3d(tx * reach + ty * along, ty * reach - tx * along, up);
    return upright(at, 90.0 * static_cast<int>(side));
}

std::optional<Plan::Niche> Plan::niche(const std::function<bool(const Cell&)>& among) {
    std::vector<Niche> all;
    for (int row = 0; row < MazeEdge; ++row) {
        for (int column = 0; column < MazeEdge; ++column) {
            const Cell cell{column, row};
            if (taken(cell) || (among && !among(cell))) continue;
            for (int i = 0; i < SideCount; ++i) {
                const Side side = static_cast<Side>(i);
                if (maze.border(cell, side) == Border::Wall) all.push_back({cell, side});
            }
        }
    }
    if (all.empty()) return std::nullopt;
    return all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
}

std::optional<Cell> Plan::freeCell() {
    std::vector<Cell> all;
    for (int row = 0; row < MazeEdge; ++row) {
        for (int column = 0; column < MazeEdge; ++column) {
            if (!taken({column, row})) all.push_back({column, row});
        }
    }
    if (all.empty()) return std::nullopt;
    return all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
}

Element& Plan::add(Element element) {
    element.name =
        fmt::format("{} {}", toString(element.kind), ++m_count[static_cast<std::size_t>(element.kind)]);
    for (char& one : element.name) {
        if (one == '_') one = ' ';
    }
    arena.elements.push_back(std::move(element));
    return arena.elements.back();
}

}  // namespace leitstand::simulation
