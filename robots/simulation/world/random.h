#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace leitstand::simulation {

/// Numbers that are the same on every machine for the same seed (splitmix64, Steele et al. 2014), unlike
/// those of the standard library's distributions.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (m_state += 0x9E3779B97F4A7C15ULL);
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }
    /// 0 <= u < 1.
    double uniform() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
    /// Normal with mean 0 and deviation 1 (Box and Muller 1958).
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }

private:
    std::uint64_t m_state;
};

}  // namespace leitstand::simulation
