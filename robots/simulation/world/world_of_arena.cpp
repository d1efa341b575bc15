#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

World::World(const Arena& arena, std::uint64_t seed, Time start) : World(arena, meshOf(arena), seed, start) {}

}  // namespace leitstand::simulation
