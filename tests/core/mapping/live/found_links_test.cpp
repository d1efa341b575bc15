#include "core/mapping/live/loops/links/found_links.h"

#include <gtest/gtest.h>

namespace leitstand {
namespace {

/// What a match says along x [1/m^2] that is certain by @p certainty along it, and all else by 1.
double heldAlongX(double certainty) {
    IcpResult icp;
    icp.information = Information::Identity() / 3.0;
    icp.information(0, 0) = certainty / 3.0;
    return informationOf(icp, Pose::Identity(), LoopSettings(), MatchSettings())(0, 0);
}

TEST(FoundLinks, AMatchSaysLessWhereOdometryHadASay) {
    const double whole = heldAlongX(1.0);
    EXPECT_NEAR(whole, 1.0 / (0.01 * 0.01), 1e-6) << "a centimetre";
    EXPECT_NEAR(heldAlongX(0.1), whole, 1e-6);
    EXPECT_NEAR(heldAlongX(0.06), 0.5 * whole, 1e-6);
    EXPECT_NEAR(heldAlongX(0.02), 0.0, 1e-6) << "odometry had all of it";
    EXPECT_NEAR(heldAlongX(0.0), 0.0, 1e-6);
}

}  // namespace
}  // namespace leitstand
