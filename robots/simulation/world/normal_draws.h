#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace leitstand::simulation {

/// One step of splitmix64 (Steele et al. 2014): well-mixed bits from any @p number.
[[nodiscard]] inline std::uint64_t mixed(std::uint64_t number) {
    std::uint64_t z = number + 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}

/// Normal numbers with mean 0 and deviation 1 (Box and Muller 1958): the same for the same seed with every
/// library, unlike std::normal_distribution.
class NormalDraws {
public:
    explicit NormalDraws(std::uint64_t seed) : m_state(seed) {}

    double next() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }

private:
    double uniform() { return static_cast<double>(mixed(m_state++) >> 11U) * 0x1.0p-53; }

    std::uint64_t m_state;
};

}  // namespace leitstand::simulation
