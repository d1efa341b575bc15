#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace leitstand::simulation {

/// A stream of random numbers (xoshiro256++, Blackman & Vigna 2019): the same for the same seed and name on
/// every machine, and independent of all others.
class Noise {
public:
    /// Creates the stream that belongs to @p name ("kurt3d left") among those of @p seed.
    Noise(std::uint64_t seed, std::string_view name);

    [[nodiscard]] std::uint64_t bits();
    [[nodiscard]] double uniform();  ///< from 0 up to below 1
    [[nodiscard]] double normal();   ///< mean 0, standard deviation 1
    /// Returns a nearly normal number for pixels: the sum of four uniform ones, never beyond 3.5.
    [[nodiscard]] float quickNormal();

private:
    std::array<std::uint64_t, 4> m_state{};
    double m_spare = 0.0;
    bool m_hasSpare = false;
};

}  // namespace leitstand::simulation
