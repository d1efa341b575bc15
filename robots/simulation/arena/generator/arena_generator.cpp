#include "robots/simulation/arena/arena_generator.h"

#include <algorithm>

#include "robots/simulation/arena/building_generator.h"
#include "robots/simulation/arena/generator/plan.h"
#include "robots/simulation/arena/reachable_floor.h"

namespace leitstand::simulation {
namespace {

constexpr double RobotRadius = 0.25;  ///< robots 0.5 m wide must reach victims [m]
constexpr std::uint64_t Attempts = 50;

/// Returns whether robots can reach what they must find. In a yellow arena this is every victim that is not
/// hidden. Kurt3D cannot cross arenas of other grades; these only need room to start.
bool good(const Arena& arena) {
    const ReachableFloor floor = reachableFloor(arena, RobotRadius);
    for (const auto& [name, start] : arena.starts) {
        if (!floor.at(start.translation().head<2>())) return false;
    }
    if (arena.grade != Grade::Yellow) return true;
    int victims = 0;
    for (const Element& element : arena.elements) {
        if (element.kind != ElementKind::Victim) continue;
        ++victims;
        if (!element.victim->hidden && !reaches(floor, element)) return false;
    }
    const double ground = (arena.to - arena.from).prod();
    return victims >= 3 && floor.area() > 0.2 * ground;
}

}  // namespace

Arena generateArena(Grade grade, std::uint64_t seed) {
    if (grade == Grade::Building) return std::move(generateBuilding({}, seed)->arena);
    const auto make = grade == Grade::Yellow ? yellowArena : grade == Grade::Orange ? orangeArena : redArena;
    Arena arena;
    for (std::uint64_t attempt = 0; attempt < Attempts; ++attempt) {
        arena = make(seed, attempt);
        if (good(arena)) break;
    }
    return arena;
}

}  // namespace leitstand::simulation
