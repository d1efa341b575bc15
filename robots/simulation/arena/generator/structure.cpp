#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/generator/plan.h"

namespace leitstand::simulation {
namespace {

constexpr double Surroundings = 3.0;  ///< width of the ground around the arena [m]

Border lineBorder(const Plan& plan, bool level, int line, int i) {
    // Line 0 is the arena's south or west edge, MazeEdge its other edge.
    if (level)
        return line < MazeEdge ? plan.maze.border({i, line}, Side::South)
                               : plan.maze.border({i, line - 1}, Side::North);
    return line < MazeEdge ? plan.maze.border({line, i}, Side::West)
                           : plan.maze.border({line - 1, i}, Side::East);
}

/// Returns the top of the walls between two cells, WallHeight above the higher floor [m].
double topOf(Plan& plan, bool level, int line, int i) {
    double top = 0.0;
    for (const int side : {line - 1, line}) {
        const Cell cell = level ? Cell{i, side} : Cell{side, i};
        if (plan.maze.has(cell)) top = std::max(top, plan.level(cell));
    }
    return Plan::rounded(top + WallHeight);
}

void addWall(Plan& plan, bool level, int line, int first, int last, double top) {
    Element wall = elementOf(ElementKind::Wall);
    wall.size = {Plan::rounded((last - first) * CellEdge + WallThickness), WallThickness, top};
    if (plan.random.chance(0.15)) wall.material = Material::Plaster;
    const double along = (first + last) / 2.0 * CellEdge;
    const double across = line * CellEdge;
    const bool outer = line == 0 || line == MazeEdge;
    // The face of an outer wall points inwards; other walls may face either way.
    wall.pose =
        Plan::upright(level ? Eigen::Vector3d(along, across, 0.0) : Eigen::Vector3d(across, along, 0.0),
                      (level ? 0.0 : 90.0) + (outer && line > 0 ? 180.0 : 0.0));
    plan.add(wall);
}

void addLine(Plan& plan, bool level, int line) {
    for (int i = 0; i < MazeEdge;) {
        const Border border = lineBorder(plan, level, line, i);
        const double top = topOf(plan, level, line, i);
        int end = i + 1;
        if (border == Border::Wall) {
            while (end < MazeEdge && lineBorder(plan, level, line, end) == border &&
                   topOf(plan, level, line, end) == top)
                ++end;
            addWall(plan, level, line, i, end, top);
        } else if (border != Border::Open) {
            Element element = elementOf(border == Border::Door ? ElementKind::Door : ElementKind::Curtain);
            const double base = top - WallHeight;
            const double along = (i + 0.5) * CellEdge;
            const double turn = (level ? 0.0 : 90.0) + (plan.random.chance(0.5) ? 180.0 : 0.0);
            element.pose = Plan::upright(level ? Eigen::Vector3d(along, line * CellEdge, base)
                                               : Eigen::Vector3d(line * CellEdge, along, base),
                                         turn);
            element.size = {Plan::rounded(CellEdge - WallThickness), WallThickness, WallHeight};
            if (border == Border::Door) {
                element.width = plan.length(0.95, 1.05);
                element.angle = degrees(std::round(plan.random.between(88, 100)));
            } else {
                element.size.x() = Plan::rounded(CellEdge - 0.1);
                element.pose.translation().z() = Plan::rounded(base + 0.03);
                element.size.z() = plan.length(0.9, 1.15);
                element.seed = plan.random.next() % 1000;
            }
            plan.add(element);
        }
        i = end;
    }
}

}  // namespace

void placeStarts(Plan& plan) {
    const bool east = plan.random.chance(0.5);  // which corner
    const Cell first{east ? MazeEdge - 1 : 0, 0};
    const Cell second{east ? MazeEdge - 2 : 1, 0};
    plan.maze.setBorder(first, east ? Side::West : Side::East, Border::Open);
    plan.take(first);
    plan.take(second);
    const Eigen::Vector3d between = (plan.middle(first) + plan.middle(second)) / 2;
    // Robots face north when a way leads out there, so that none starts right in front of a wall.
    const bool north = plan.maze.border(first, Side::North) != Border::Wall ||
                       plan.maze.border(second, Side::North) != Border::Wall;
    const double heading = north ? 90.0 : (east ? 180.0 : 0.0);
    const Eigen::Vector3d apart = north ? Eigen::Vector3d(0.4, 0.0, 0.0) : Eigen::Vector3d(0.0, 0.28, 0.0);
    plan.arena.starts["kurt3d"] = Plan::upright(between - apart, heading);
    plan.arena.starts["crawler"] = Plan::upright(between + apart, heading);
}

void raiseWalls(Plan& plan) {
    Element floor = elementOf(ElementKind::Floor);
    const double edge = MazeEdge * CellEdge;
    floor.size = {Plan::rounded(edge + 2 * Surroundings), Plan::rounded(edge + 2 * Surroundings), 0.1};
    floor.pose = Plan::upright({edge / 2, edge / 2, 0.0}, 0.0);
    plan.add(floor);
    for (int line = 0; line <= MazeEdge; ++line) {
        addLine(plan, true, line);
        addLine(plan, false, line);
    }
}

void hangDoors(Plan& plan, int doors, int curtains) {
    for (int tries = 0; tries < 200 && doors + curtains > 0; ++tries) {
        const Cell cell{plan.random.below(MazeEdge), plan.random.below(MazeEdge)};
        const Side side = plan.random.chance(0.5) ? Side::North : Side::East;
        const Cell next = beyond(cell, side);
        if (!plan.maze.has(next) || plan.maze.border(cell, side) != Border::Open) continue;
        if (plan.taken(cell) || plan.taken(next)) continue;
        if (doors > 0) {
            plan.maze.setBorder(cell, side, Border::Door);
            --doors;
        } else {
            // A curtain looks like an obstacle, so it never hangs in the only way.
            if (!plan.maze.connectedWithout(cell, side)) continue;
            plan.maze.setBorder(cell, side, Border::Curtain);
            --curtains;
        }
        plan.take(cell);
        plan.take(next);
    }
}

void addCeilings(Plan& plan, double share) {
    for (int row = 0; row < MazeEdge; ++row) {
        for (int column = 0; column < MazeEdge; ++column) {
            if (!plan.random.chance(share)) continue;
            Element ceiling = elementOf(ElementKind::Ceiling);
            ceiling.size = {CellEdge, CellEdge, 0.02};
            if (plan.random.chance(0.5)) ceiling.material = Material::Plywood;
            ceiling.pose = Plan::upright(plan.middle({column, row}) + Eigen::Vector3d(0, 0, WallHeight), 0.0);
            plan.add(ceiling);
        }
    }
}

void addRidges(Plan& plan, int count, double steepest) {
    constexpr double Slope = 0.45;  ///< length of each of the two ramps [m]
    constexpr double Top = 0.3;     ///< length between the ramps [m]
    for (int row = 0; row < MazeEdge && count > 0; ++row) {
        for (int column = 0; column < MazeEdge && count > 0; ++column) {
            const Cell cell{column, row};
            const auto open = [&](Side side) { return plan.maze.border(cell, side) == Border::Open; };
            const bool northward =
                open(Side::North) && open(Side::South) && !open(Side::East) && !open(Side::West);
            const bool eastward =
                open(Side::East) && open(Side::West) && !open(Side::North) && !open(Side::South);
            if (plan.taken(cell) || northward == eastward || plan.random.chance(0.3)) continue;
            --count;
            plan.take(cell);
            const double height = Plan::rounded(Slope * std::tan(plan.random.between(0.5, 1.0) * steepest));
            const double width = CellEdge - WallThickness;
            const double heading = northward ? 90.0 : 0.0;
            const Eigen::Vector3d along = northward ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
            for (const double side : {-1.0, 1.0}) {
                Element ramp = elementOf(ElementKind::Ramp);
                ramp.size = {Slope, width, height};
                ramp.pose = Plan::upright(plan.middle(cell) + side * (Top + Slope) / 2 * along,
                                          heading + (side > 0 ? 180.0 : 0.0));
                plan.add(ramp);
            }
            Element top = elementOf(ElementKind::Floor);
            top.size = {Top, width, height};
            top.material = Material::Plywood;
            top.pose = Plan::upright(plan.middle(cell) + Eigen::Vector3d(0, 0, height), heading);
            plan.add(top);
        }
    }
}

}  // namespace leitstand::simulation
