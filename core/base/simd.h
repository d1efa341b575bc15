#pragma once

#include <cstdint>

namespace leitstand {

/// Vector instructions that this program has code for; all levels give the same answers.
enum class SimdLevel : std::uint8_t {
    Plain,  ///< what every processor of the architecture has
    Avx2,   ///< 8 floats at a time
};

/// Returns the best level of this processor. The environment variable LEITSTAND_SIMD=plain, read once,
/// forbids all levels above Plain.
[[nodiscard]] SimdLevel simdLevel();

}  // namespace leitstand
