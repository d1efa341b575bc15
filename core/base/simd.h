#pragma once

#include <cstdint>

namespace leitstand {

/// Vector instructions for which this program has code. All levels give the same results.
enum class SimdLevel : std::uint8_t {
    Plain,  ///< what every processor of this architecture has
    Avx2,   ///< 8 floats at a time
};

/// Returns the best level that this processor supports. The environment variable LEITSTAND_SIMD=plain, which
/// is read once, forbids all levels above Plain.
[[nodiscard]] SimdLevel simdLevel();

}  // namespace leitstand
