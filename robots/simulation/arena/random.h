#pragma once

#include <cstdint>

#include "core/base/mixed_bits.h"

namespace leitstand::simulation {

/// Random numbers that are the same on every machine and with every library (SplitMix64, Steele et al. 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next() {
        const std::uint64_t bits = mixedBits(m_state);
        m_state += MixedBitsStep;
        return bits;
    }
    /// Returns a random number of at least 0 and below 1.
    double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
    double between(double least, double most) { return least + (most - least) * uniform(); }
    /// Returns a random whole number of at least 0 and below @p count, which must be positive.
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
    bool chance(double probability) { return uniform() < probability; }

private:
    std::uint64_t m_state;
};

}  // namespace leitstand::simulation
