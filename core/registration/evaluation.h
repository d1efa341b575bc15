#pragma once

#include "core/registration/icp.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// Information that the surfaces at pairs give about a pose, see IcpResult::information.
struct PairInformation {
    Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
    double radius = 0.0;  ///< root mean square distance of the paired source points from @p centre [m]
};
/// Computes the information about @p pose from pairs whose squared distance is below @p maxSquared [m^2].
/// Zero when no such pair has a normal. @p centre: in the target's frame [m].
[[nodiscard]] PairInformation informationOf(const Pairing& pairing, const Pose& pose,
                                            const Eigen::Vector3d& centre, double maxSquared);

/// Sets the fields that say how well @p result.pose fits: rms, inlier ratio, overlap, information, certainty
/// and weakest direction. @p paired: maximum distance in the last search of @p pairing [m]. Pairs within
/// @p maxDistance [m] are inliers.
void evaluate(Pairing& pairing, double paired, double maxDistance, IcpResult& result);

}  // namespace leitstand
