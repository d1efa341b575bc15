#pragma once

#include <cstdint>
#include <cstdlib>

namespace leitstand::simulation::test {

/// Of the worlds that are measured. Worlds 1 to 9 are for tuning, 101 and up for measuring:
/// LEITSTAND_BUILDING_SEED=3 takes another one.
[[nodiscard]] inline std::uint64_t measuredSeed() {
    const char* seed = std::getenv("LEITSTAND_BUILDING_SEED");
    return seed == nullptr ? 101 : std::strtoull(seed, nullptr, 10);
}

/// How many buildings, each of its own seed: LEITSTAND_BUILDINGS=2 takes fewer than @p usual.
[[nodiscard]] inline int measuredBuildings(int usual) {
    const char* reported = std::getenv("LEITSTAND_BUILDINGS");
    return reported == nullptr ? usual : std::atoi(reported);
}

/// Of the first of them: LEITSTAND_SEED=3 takes others than from @p usual on.
[[nodiscard]] inline std::uint64_t firstSeed(std::uint64_t usual) {
    const char* reported = std::getenv("LEITSTAND_SEED");
    return reported == nullptr ? usual : std::strtoull(reported, nullptr, 10);
}

}  // namespace leitstand::simulation::test
