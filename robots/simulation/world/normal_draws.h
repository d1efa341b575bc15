#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/mixed_bits.h"

namespace leitstand::simulation {

/// Normal random numbers with mean 0 and standard deviation 1 (Box and Muller 1958). The same seed gives the
/// same numbers with every library, unlike std::normal_distribution.
class NormalDraws {
public:
    explicit NormalDraws(std::uint64_t seed) : m_state(seed) {}

    double next() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
        return radius * std::cos(2.0 * std::numbers::pi * uniform());
    }

private:
    double uniform() { return static_cast<double>(mixedBits(m_state++) >> 11U) * 0x1.0p-53; }

    std::uint64_t m_state;
};

}  // namespace leitstand::simulation
