#pragma once

#include <cstdint>

namespace leitstand {

/// Vector instructions for which there is code of our own; all levels give the same answers.
enum class SimdLevel : std::uint8_t {
    Plain,  ///< what every processor of the architecture has
    Avx2,   ///< 8 floats at once
};

/// The best level of this processor. The environment LEITSTAND_SIMD=plain, read once, forbids more than
/// Plain.
[[nodiscard]] SimdLevel simdLevel();

}  // namespace leitstand
