#include "core/mapping/motion/odometry_scale.h"

#include <gtest/gtest.h>

namespace leitstand {
namespace {

TEST(OdometryScale, IsOneUntilSomethingIsKnown) {
    OdometryScale scale;
    EXPECT_EQ(scale.factor(), 1.0);
    scale.add(0.0, 0.0);
    EXPECT_EQ(scale.factor(), 1.0);
    scale.add(0.4, 0.5);
    EXPECT_NEAR(scale.factor(), 1.0, 0.015) << "one step tells little";
}

TEST(OdometryScale, ComesToTheRatioOfTheWays) {
    OdometryScale scale;
    for (int i = 0; i < 200; ++i) scale.add(0.4, 0.4 * 1.03);
    EXPECT_NEAR(scale.factor(), 1.03, 0.007);
}

TEST(OdometryScale, FollowsTheGround) {
    OdometryScale scale;
    for (int i = 0; i < 200; ++i) scale.add(0.4, 0.4 * 1.03);
    for (int i = 0; i < 400; ++i) scale.add(0.4, 0.4 * 0.98);
    EXPECT_NEAR(scale.factor(), 0.98, 0.007) << "160 m later";
}

TEST(OdometryScale, NeverBelievesNonsense) {
    OdometryScale scale;
    for (int i = 0; i < 200; ++i) scale.add(0.4, 4.0);
    EXPECT_LE(scale.factor(), 1.15);
}

}  // namespace
}  // namespace leitstand
