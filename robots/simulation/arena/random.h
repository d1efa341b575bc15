#pragma once

#include <cstdint>

namespace leitstand::simulation {

/// Random numbers that are the same on every machine and with every library (SplitMix64, Steele et al. 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next() {
        m_state += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }
    /// From 0 to below 1.
    double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
    double between(double least, double most) { return least + (most - least) * uniform(); }
    /// From 0 to below @p count, which is positive.
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
    bool chance(double probability) { return uniform() < probability; }

private:
    std::uint64_t m_state;
};

}  // namespace leitstand::simulation
