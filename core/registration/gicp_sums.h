#pragma once

#include <cstddef>

#include "core/registration/normal_equations.h"

namespace leitstand {

/// The part of gicpEquations() from the source points [@p first, @p last), few enough for sums of floats.
[[nodiscard]] NormalEquations gicpSums(const Pairing& pairing, const Pose& sourceInTarget,
                                       const Eigen::Vector3d& centre, double kernel, std::size_t first,
                                       std::size_t last);

}  // namespace leitstand
