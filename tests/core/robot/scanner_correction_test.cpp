#include "core/robot/scanner_correction.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"

namespace leitstand::test {
namespace {

TEST(ScannerCorrection, MovesPointsAlongTheirRaysAndLeavesWhatIsNoEcho) {
    constexpr float None = std::numeric_limits<float>::quiet_NaN();
    CloudSample cloud;
    cloud.points = {{3.0F, 4.0F, 0.0F}, {0.0F, 0.0F, 0.01F}, {0.0F, 0.0F, 0.0F}, {None, None, None}};
    ScannerCorrection{-0.02, degrees(1), 0.0}.correct(cloud);
    EXPECT_TRUE(cloud.points[0].isApprox(Eigen::Vector3f(2.988F, 3.984F, 0.0F), 1e-5F));
    EXPECT_EQ(cloud.points[1], Eigen::Vector3f::Zero()) << "not behind the scanner";
    EXPECT_EQ(cloud.points[2], Eigen::Vector3f::Zero());
    EXPECT_FALSE(cloud.points[3].allFinite());
}

TEST(ScannerCorrection, TurnsTheMountInTheRobotsBase) {
    const Pose reported = poseFrom({0.1, 0.0, 0.5}, 0.0, 0.0, degrees(90));
    const Pose is = ScannerCorrection{0.0, 0.0, degrees(2)}.corrected(reported);
    EXPECT_EQ(is.translation(), reported.translation());
    // Pitched: what the scanner sees to its right, which is ahead of the robot, lies lower.
    EXPECT_NEAR((is.linear() * Eigen::Vector3d(0, -1, 0)).z(), -std::sin(degrees(2)), 1e-12);
}

TEST(ScannerCorrection, MovesAndTurnsTheMountAndSetsTheClock) {
    ScannerCorrection correction;
    correction.x = 0.02;
    correction.y = -0.01;
    correction.yaw = degrees(90);
    correction.clock = -0.06;
    const Pose is = correction.corrected(poseFrom({0.1, 0.2, 0.5}, 0, 0, 0));
    EXPECT_TRUE(is.isApprox(poseFrom({0.12, 0.19, 0.5}, 0, 0, degrees(90)), 1e-12)) << "about itself";
    CloudSample cloud;
    cloud.header.stamp = Time{} + std::chrono::seconds(10);
    correction.correct(cloud);
    EXPECT_EQ(cloud.header.stamp, Time{} + std::chrono::milliseconds(9940));
    CloudSample unstamped;
    correction.correct(unstamped);
    EXPECT_EQ(unstamped.header.stamp, Time{}) << "counts as taken when it came";
    EXPECT_EQ(correction.with(correction).yaw, ScannerCorrection::MostTurn);
    EXPECT_NEAR(correction.with(correction).clock, -0.12, 1e-12);
}

TEST(ScannerCorrection, AddsUpWithinWhatAScannerCanBeOff) {
    const ScannerCorrection sum =
        ScannerCorrection{-0.02, degrees(0.3), 0.0}.with({0.005, degrees(0.1), 0.0});
    EXPECT_NEAR(sum.range, -0.015, 1e-12);
    EXPECT_NEAR(sum.roll, degrees(0.4), 1e-12);
    EXPECT_FALSE(sum.isNone());
    EXPECT_TRUE(ScannerCorrection().isNone());
    EXPECT_EQ((ScannerCorrection{0.15, 0.0, 0.0}.with({0.15, 0.0, 0.0}).range), ScannerCorrection::MostRange);
}

}  // namespace
}  // namespace leitstand::test
