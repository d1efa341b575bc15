#pragma once

#include "core/registration/icp.h"
#include "core/registration/pairing.h"

namespace leitstand {

/// Fills in how well @p result.pose fits: rms, inlier ratio, overlap, information, certainty and weakest
/// direction. @p maxDistance: farthest pair that counts as inlier [m].
void evaluate(Pairing& pairing, double maxDistance, IcpResult& result);

}  // namespace leitstand
