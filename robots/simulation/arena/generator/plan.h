#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robots/simulation/arena/arena.h"
#include "robots/simulation/arena/generator/maze.h"

namespace leitstand::simulation {

inline constexpr double CellEdge = 1.3;        ///< edge of a maze's cell, from wall to wall [m]
inline constexpr double WallThickness = 0.05;  ///< [m]
inline constexpr double WallHeight = 1.2;      ///< [m]
inline constexpr int MazeEdge = 6;             ///< edge of a maze [cells]

/// An arena while it is being generated: its maze, its dice, and which cells are in use.
class Plan {
public:
    Plan(Grade grade, std::uint64_t seed, std::uint64_t attempt);

    Random random;
    Maze maze;
    Arena arena;

    /// Rounds a length to millimetres [m]. Numbers in files are short: millimetres, and tenths of a degree.
    [[nodiscard]] static double rounded(double value);
    double length(double least, double most) { return rounded(random.between(least, most)); }

    /// Returns the height of a cell's floor [m].
    [[nodiscard]] double& level(const Cell& cell) { return m_level[index(cell)]; }
    /// Returns whether a cell contains something large or must stay free.
    [[nodiscard]] bool taken(const Cell& cell) const { return m_taken[index(cell)] != 0; }
    void take(const Cell& cell) { m_taken[index(cell)] = 1; }

    /// Returns the middle of a cell's floor [m].
    [[nodiscard]] Eigen::Vector3d middle(const Cell& cell);
    /// Returns a frame in front of the wall at @p side of a cell. It is @p distance from the wall, shifted by
    /// @p along the wall, and @p up above the floor [m]. Its y axis points to the wall.
    [[nodiscard]] Pose before(const Cell& cell, Side side, double distance, double along = 0.0,
                              double up = 0.0);
    [[nodiscard]] static Pose upright(const Eigen::Vector3d& position, double inDegrees);

    /// A cell that is not in use, with one of its sides that is a wall.
    struct Niche {
        Cell cell;
        Side side = Side::North;
    };
    [[nodiscard]] std::optional<Niche> niche(const std::function<bool(const Cell&)>& among = {});
    [[nodiscard]] std::optional<Cell> freeCell();

    /// Adds @p element under a unique name: "wall 12".
    Element& add(Element element);

private:
    [[nodiscard]] static std::size_t index(const Cell& cell) {
        return static_cast<std::size_t>(cell.row * MazeEdge + cell.column);
    }
    std::array<double, MazeEdge * MazeEdge> m_level{};
    std::array<char, MazeEdge * MazeEdge> m_taken{};
    std::array<int, ElementKindCount> m_count{};
};

// Steps of generating an arena.
void placeStarts(Plan& plan);  ///< keeps two cells at the corner free for the robots
void raiseWalls(Plan& plan);   ///< adds floor, walls, doors and curtains according to the borders
void hangDoors(Plan& plan, int doors, int curtains);
void addCeilings(Plan& plan, double share);
void addRidges(Plan& plan, int count, double steepest);  ///< adds ramps up and down across corridors
void addVictims(Plan& plan, int count);
void addFurniture(Plan& plan, int count);
void addLamps(Plan& plan);
void addHeaters(Plan& plan, int count);
void addSoftThings(Plan& plan, int count);
void addSigns(Plan& plan, int count);
void addSpectators(Plan& plan, int count);

/// Generates an arena of the grade: a maze with things in it. Each @p attempt gives a different arena.
[[nodiscard]] Arena yellowArena(std::uint64_t seed, std::uint64_t attempt);
[[nodiscard]] Arena orangeArena(std::uint64_t seed, std::uint64_t attempt);
[[nodiscard]] Arena redArena(std::uint64_t seed, std::uint64_t attempt);

}  // namespace leitstand::simulation
