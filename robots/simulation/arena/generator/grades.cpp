#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/generator/plan.h"

namespace leitstand::simulation {
namespace {

bool any(const Cell&) {
    return true;
}

void finish(Plan& plan, int lamps, int heaters) {
    if (lamps > 0) addLamps(plan);
    addHeaters(plan, heaters);
}

/// Raises two rows of cells in the north; stairs and a ramp lead there.
void raiseNorth(Plan& plan) {
    constexpr int First = MazeEdge - 2;  ///< first row of the upper level
    const double riser = Plan::rounded(std::round(plan.random.between(0.08, 0.1) * 200.0) / 200.0);
    const double height = Plan::rounded(4 * riser);
    const int stairs = plan.random.below(MazeEdge / 2);
    const int ramp = MazeEdge / 2 + plan.random.below(MazeEdge / 2);
    const bool mirrored = plan.random.chance(0.5);
    const int stairsColumn = mirrored ? MazeEdge - 1 - stairs : stairs;
    const int rampColumn = mirrored ? MazeEdge - 1 - ramp : ramp;

    const auto isWay = [&](const Cell& cell) {
        return (cell.column == stairsColumn && cell.row == First - 1) ||
               (cell.column == rampColumn && (cell.row == First - 1 || cell.row == First - 2));
    };
    const auto low = [&](const Cell& cell) { return cell.row < First && !isWay(cell); };
    const auto high = [&](const Cell& cell) { return cell.row >= First; };
    plan.maze.carve(plan.random, {0, 0}, low);
    plan.maze.carve(plan.random, {0, First}, high);
    plan.maze.loosen(plan.random, 0.3, low);
    plan.maze.loosen(plan.random, 0.3, high);
    for (int row = 0; row < MazeEdge; ++row) {
        for (int column = 0; column < MazeEdge; ++column) {
            const Cell cell{column, row};
            if (high(cell)) plan.level(cell) = height;
            if (!isWay(cell)) continue;
            plan.take(cell);
            plan.maze.setBorder(cell, Side::South, Border::Open);
            plan.maze.setBorder(cell, Side::North, Border::Open);
        }
    }
    const double edge = MazeEdge * CellEdge;
    Element slab = elementOf(ElementKind::Floor);
    slab.material = Material::Plywood;
    slab.size = {edge, Plan::rounded(2 * CellEdge), height};
    slab.pose = Plan::upright({edge / 2, edge - CellEdge, height}, 0.0);
    plan.add(slab);

    const double width = CellEdge - WallThickness;
    Element steps = elementOf(ElementKind::Stairs);
    steps.size = {1.12, width, height};
    steps.riser = riser;
    steps.pose = Plan::upright({(stairsColumn + 0.5) * CellEdge, First * CellEdge - 0.56, 0.0}, 90.0);
    plan.add(steps);
    Element slope = elementOf(ElementKind::Ramp);
    slope.size = {Plan::rounded(2 * CellEdge - 0.2), width, height};
    slope.pose = Plan::upright({(rampColumn + 0.5) * CellEdge, First * CellEdge - CellEdge + 0.1, 0.0}, 90.0);
    plan.add(slope);
}

/// Returns a field of wooden columns as in the rescue leagues: hills, ridges and diagonals of steps.
Element stepFieldFor(Plan& plan) {
    constexpr int Edge = 12;
    constexpr double Step = 0.05;
    Element field = elementOf(ElementKind::StepField);
    field.size = {1.2, 1.2, 0.25};
    const int shape = plan.random.below(3);
    for (int row = 0; row < Edge; ++row) {
        for (int column = 0; column < Edge; ++column) {
            const int fromEdge = std::min({row, column, Edge - 1 - row, Edge - 1 - column});
            const int fromMiddle = std::abs(2 * row - Edge + 1) / 2;
            const int fromDiagonal = std::abs(row - column);
            int high = shape == 0 ? fromEdge / 2 + 1 : shape == 1 ? 4 - fromMiddle : 4 - fromDiagonal / 2;
            high = std::clamp(high + plan.random.below(3) - 1, 0, std::min(4, fromEdge + 1));
            field.heights.push_back(Plan::rounded(Step * high));
        }
    }
    return field;
}

}  // namespace

Arena yellowArena(std::uint64_t seed, std::uint64_t attempt) {
    Plan plan(Grade::Yellow, seed, attempt);
    plan.maze.carve(plan.random, {plan.random.below(MazeEdge), plan.random.below(MazeEdge)}, any);
    plan.maze.loosen(plan.random, 0.22, any);
    placeStarts(plan);
    addRidges(plan, 1 + plan.random.below(2), degrees(15));
    hangDoors(plan, 1 + plan.random.below(2), 1);
    raiseWalls(plan);
    addCeilings(plan, 0.25);
    addVictims(plan, 3 + plan.random.below(4));
    finish(plan, 1, 1 + plan.random.below(2));
    addFurniture(plan, 3 + plan.random.below(3));
    addSoftThings(plan, 2 + plan.random.below(3));
    addSigns(plan, 7);
    addSpectators(plan, 2 + plan.random.below(4));
    return std::move(plan.arena);
}

Arena orangeArena(std::uint64_t seed, std::uint64_t attempt) {
    Plan plan(Grade::Orange, seed, attempt);
    raiseNorth(plan);
    placeStarts(plan);
    addRidges(plan, 2, degrees(20));
    raiseWalls(plan);
    addCeilings(plan, 0.2);
    addVictims(plan, 4 + plan.random.below(3));
    finish(plan, 1, 1);
    addFurniture(plan, 2 + plan.random.below(3));
    addSoftThings(plan, 2);
    addSigns(plan, 7);
    addSpectators(plan, 2 + plan.random.below(3));
    return std::move(plan.arena);
}

Arena redArena(std::uint64_t seed, std::uint64_t attempt) {
    Plan plan(Grade::Red, seed, attempt);
    plan.maze.carve(plan.random, {plan.random.below(MazeEdge), plan.random.below(MazeEdge)}, any);
    plan.maze.loosen(plan.random, 0.7, any);
    placeStarts(plan);
    raiseWalls(plan);
    addVictims(plan, 4 + plan.random.below(3));
    for (int i = 0; i < 10; ++i) {
        const auto cell = plan.freeCell();
        if (!cell) break;
        plan.take(*cell);
        Element field = stepFieldFor(plan);
        field.pose = Plan::upright(plan.middle(*cell), 90.0 * plan.random.below(4));
        plan.add(field);
    }
    for (int i = 0; i < 5; ++i) {
        const auto cell = plan.freeCell();
        if (!cell) break;
        plan.take(*cell);
        Element heap = elementOf(ElementKind::Rubble);
        heap.size = {plan.length(0.9, 1.2), plan.length(0.9, 1.2), plan.length(0.15, 0.3)};
        heap.seed = plan.random.next() % 1000;
        heap.pose = Plan::upright(plan.middle(*cell), plan.random.between(0.0, 90.0));
        plan.add(heap);
    }
    finish(plan, 1, 1);
    addFurniture(plan, 2);
    addSoftThings(plan, 2);
    addSigns(plan, 6);
    addSpectators(plan, 2 + plan.random.below(3));
    return std::move(plan.arena);
}

}  // namespace leitstand::simulation
