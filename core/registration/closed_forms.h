#pragma once

#include <cstdint>

#include "core/base/pose.h"
#include "core/registration/pair_sums.h"

namespace leitstand {

/// Result of a closed-form solution.
enum class FitOutcome : std::uint8_t {
    Ok,
    TooFewPairs,  ///< fewer than 3 pairs: the pose is the identity
    Collinear,    ///< all points are on a line, so the rotation about it is open: the pose is one of many
    Mirror,       ///< a reflection would fit better: the pose is still the best rigid motion
};

/// The motion that maps the source points onto their partners with the least sum of squared distances.
struct Fit {
    FitOutcome outcome = FitOutcome::Ok;
    Pose pose = Pose::Identity();  ///< maps source onto target
};

/// Singular value decomposition: Arun, Huang & Blostein 1987; equations (2) to (7) of the paper.
[[nodiscard]] Fit fitBySvd(const PairSums& sums);
/// Unit quaternion as an eigenvector of a 4x4 matrix: Horn 1987.
[[nodiscard]] Fit fitByQuaternion(const PairSums& sums);
/// Orthonormal matrix by the root of a matrix: Horn, Hilden & Negahdaripour 1988.
[[nodiscard]] Fit fitByOrthonormal(const PairSums& sums);
/// Dual quaternion, rotation and translation at once: Walker, Shao & Volz 1991.
[[nodiscard]] Fit fitByDualQuaternion(const PairSums& sums);

}  // namespace leitstand
