#pragma once

#include "core/registration/icp.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// What surfaces at pairs tell of a pose, see IcpResult::information.
struct PairInformation {
    Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
    double radius = 0.0;  ///< root mean squared distance of the source's points from @p centre [m]
};
/// ... of the pairs nearer than the root of @p maxSquared [m^2].
[[nodiscard]] PairInformation informationOf(const Pairing& pairing, const Pose& pose,
                                            const Eigen::Vector3d& centre, double maxSquared);

/// Fills in how well @p result.pose fits: rms, inlier ratio, overlap, information, certainty and weakest
/// direction. @p paired: how far @p pairing looked for partners last [m]; @p maxDistance: farthest pair that
/// counts as inlier [m].
void evaluate(Pairing& pairing, double paired, double maxDistance, IcpResult& result);

}  // namespace leitstand
