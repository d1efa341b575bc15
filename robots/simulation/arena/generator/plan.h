#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robots/simulation/arena/arena.h"
#include "robots/simulation/arena/generator/maze.h"

namespace leitstand::simulation {

inline constexpr double CellEdge = 1.3;        ///< of a maze, from wall to wall [m]
inline constexpr double WallThickness = 0.05;  ///< [m]
inline constexpr double WallHeight = 1.2;      ///< [m]
inline constexpr int MazeEdge = 6;             ///< cells

/// An arena in the making: its maze, what is where in it, and dice.
class Plan {
public:
    Plan(Grade grade, std::uint64_t seed, std::uint64_t attempt);

    Random random;
    Maze maze;
    Arena arena;

    /// Numbers in files are short: millimetres and tenths of a degree.
    [[nodiscard]] static double rounded(double value);
    double length(double least, double most) { return rounded(random.between(least, most)); }

    /// Height of a cell's floor [m].
    [[nodiscard]] double& level(const Cell& cell) { return m_level[index(cell)]; }
    /// Whether something big stands in a cell, or nothing may.
    [[nodiscard]] bool taken(const Cell& cell) const { return m_taken[index(cell)] != 0; }
    void take(const Cell& cell) { m_taken[index(cell)] = 1; }

    /// Middle of a cell's floor.
    [[nodiscard]] Eigen::Vector3d middle(const Cell& cell);
    /// A frame @p distance before a cell's side and @p along it, y towards the wall, @p up above the floor.
    [[nodiscard]] Pose before(const Cell& cell, Side side, double distance, double along = 0.0,
                              double up = 0.0);
    [[nodiscard]] static Pose upright(const Eigen::Vector3d& position, double inDegrees);

    /// A cell that is not taken and of which a side is a wall, with that side.
    struct Niche {
        Cell cell;
        Side side = Side::North;
    };
    [[nodiscard]] std::optional<Niche> niche(const std::function<bool(const Cell&)>& among = {});
    [[nodiscard]] std::optional<Cell> freeCell();

    /// Adds @p element with a name of its own: "wall 12".
    Element& add(Element element);

private:
    [[nodiscard]] static std::size_t index(const Cell& cell) {
        return static_cast<std::size_t>(cell.row * MazeEdge + cell.column);
    }
    std::array<double, MazeEdge * MazeEdge> m_level{};
    std::array<char, MazeEdge * MazeEdge> m_taken{};
    std::array<int, ElementKindCount> m_count{};
};

// Steps of making an arena.
void placeStarts(Plan& plan);  ///< two cells at the corner stay free for the robots
void raiseWalls(Plan& plan);   ///< floor and walls; doors and curtains where borders are such
void hangDoors(Plan& plan, int doors, int curtains);
void addCeilings(Plan& plan, double share);
void addRidges(Plan& plan, int count, double steepest);  ///< ramps up and down across corridors
void addVictims(Plan& plan, int count);
void addFurniture(Plan& plan, int count);
void addLamps(Plan& plan);
void addHeaters(Plan& plan, int count);
void addSoftThings(Plan& plan, int count);
void addSigns(Plan& plan, int count);
void addSpectators(Plan& plan, int count);

/// Mazes, filled.
[[nodiscard]] Arena yellowArena(std::uint64_t seed, std::uint64_t attempt);
[[nodiscard]] Arena orangeArena(std::uint64_t seed, std::uint64_t attempt);
[[nodiscard]] Arena redArena(std::uint64_t seed, std::uint64_t attempt);

}  // namespace leitstand::simulation
