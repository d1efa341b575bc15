#pragma once

#include <chrono>
#include <cstdint>

namespace leitstand::test {

constexpr double MostMegabytesAScan = 0.5;  ///< that enters the map, of all that a station has

/// How long a soak takes: an hour. LEITSTAND_SOAK_MINUTES shortens it for trying.
[[nodiscard]] std::chrono::duration<double> soakTime();

/// How the memory of a station grew while key scans came [MB].
struct Growth {
    double first = 0.0, last = 0.0;  ///< at rest, of the key scans below
    double most = 0.0;               ///< at any time
    std::uint64_t keyScansFirst = 0, keyScansLast = 0;
};
/// Expects that an hour fits: at most 1.2 GB at 1400 key scans, which is what an hour has at most, and so
/// much a key scan. Prints it.
void expectFits(const Growth& growth);

}  // namespace leitstand::test
