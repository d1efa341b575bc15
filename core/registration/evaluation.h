#pragma once

#include "core/registration/icp.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// Information on a pose from the surfaces at pairs, see IcpResult::information.
struct PairInformation {
    Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
    double radius = 0.0;  ///< root mean squared distance of the paired source points from @p centre [m]
};
/// Computes the information on @p pose from the pairs that are nearer than the root of @p maxSquared [m^2].
/// Zero when no such pair has a normal. @p centre: in the target's frame [m].
[[nodiscard]] PairInformation informationOf(const Pairing& pairing, const Pose& pose,
                                            const Eigen::Vector3d& centre, double maxSquared);

/// Fills in how well @p result.pose fits: rms, inlier ratio, overlap, information, certainty and weakest
/// direction. @p paired: maximum distance of the last search of @p pairing [m]. Pairs within @p maxDistance
/// [m] count as inliers.
void evaluate(Pairing& pairing, double paired, double maxDistance, IcpResult& result);

}  // namespace leitstand
