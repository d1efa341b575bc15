#pragma once

#include <cstddef>

namespace leitstand {

/// Size of the header before every serialised sample [B]. It has representation and options (RTPS 2.2,
/// section 10).
inline constexpr std::size_t EncapsulationSize = 4;

}  // namespace leitstand
