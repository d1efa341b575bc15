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

}  // namespace leitstand::simulation::test
