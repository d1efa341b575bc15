#pragma once

#include <cstddef>

#include "core/registration/normal_equations.h"

namespace leitstand {

/// Returns the part of gicpEquations() that comes from the source points [@p first, @p last). There must be
/// few, since sums are floats. The centre of the result is not set.
[[nodiscard]] NormalEquations gicpSums(const Pairing& pairing, const Pose& sourceInTarget,
                                       const Eigen::Vector3d& centre, double kernel, std::size_t first,
                                       std::size_t last);

}  // namespace leitstand
