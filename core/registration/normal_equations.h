#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// The linearised least-squares problem of a Gauss-Newton step: hessian * step = -gradient. A step consists
/// of translation [m], then rotation [rad]. It moves the source along the target's axes and turns it about
/// @p centre.
struct NormalEquations {
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< in the target's frame [m]
    double cost = 0.0;                                 ///< half the weighted sum of squares [m^2]

    /// Returns the motion by which the source's pose is multiplied from the left. Empty when the pairs leave
    /// a direction open.
    [[nodiscard]] std::optional<Pose> solve() const;
};

/// Point to plane (Chen & Medioni 1991): uses distances along the target's normals. Pairs without a normal
/// are left out. @p centre: a point in the middle of the source, in the target's frame.
[[nodiscard]] NormalEquations planeEquations(const Pairing& pairing, const Pose& sourceInTarget,
                                             const Eigen::Vector3d& centre);

/// Variance of a pair across its surface on which the weights of gicpEquations() are based when both normals
/// agree.
inline constexpr double GicpAcrossVariance = 2e-3;

/// Returns the standard deviation of the pairs' distances along the target's normals [m], estimated from
/// their median as for a normal distribution. 0 without pairs. The target must have normals.
[[nodiscard]] double deviationAcross(const Pairing& pairing, const Pose& sourceInTarget);

/// Plane to plane (Segal, Haehnel & Thrun 2009). A point has variance 1 along its surface and 1e-3 across it
/// (the paper's epsilon). So the covariance of a pair with normals a and b is 2 I - (1 - 1e-3)(a a^T + b
/// b^T). @p kernel: pairs that are farther apart than this across their surface have little weight [m] (Geman
/// & McClure 1985). 0: all have the same weight. @p centre: as for planeEquations().
[[nodiscard]] NormalEquations gicpEquations(const Pairing& pairing, const Pose& sourceInTarget,
                                            const Eigen::Vector3d& centre, double kernel = 0.0);

}  // namespace leitstand
