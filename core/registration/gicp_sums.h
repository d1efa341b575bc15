#pragma once

#include <cstddef>

#include "core/registration/normal_equations.h"

namespace leitstand {

/// Returns the part of gicpEquations() from the source points [@p first, @p last). These must be few, since
/// sums are floats; the centre of the result is not set.
[[nodiscard]] NormalEquations gicpSums(const Pairing& pairing, const Pose& sourceInTarget,
                                       const Eigen::Vector3d& centre, double kernel, std::size_t first,
                                       std::size_t last);

}  // namespace leitstand
