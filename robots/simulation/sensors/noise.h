#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace leitstand::simulation {

/// A stream of random numbers (xoshiro256++, Blackman & Vigna 2019). It is the same for the same seed and
/// name on every machine, and independent of all other streams.
class Noise {
public:
    /// Creates the stream for @p name ("kurt3d left") and @p seed.
    Noise(std::uint64_t seed, std::string_view name);

    [[nodiscard]] std::uint64_t bits();
    [[nodiscard]] double uniform();  ///< at least 0 and below 1
    [[nodiscard]] double normal();   ///< mean 0, standard deviation 1
    /// Returns an approximately normal number for pixels: the sum of four uniform numbers, at most 3.5 in
    /// size.
    [[nodiscard]] float quickNormal();

private:
    std::array<std::uint64_t, 4> m_state{};
    double m_spare = 0.0;
    bool m_hasSpare = false;
};

}  // namespace leitstand::simulation
