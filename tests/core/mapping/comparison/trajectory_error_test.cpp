#include "core/mapping/comparison/trajectory_error.h"

#include <chrono>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using namespace std::chrono_literals;
using testing::SizeIs;

Time at(double seconds) {
    return Time(1'750'000'000s) + std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

const Pose World = poseFrom({5.0, -2.0, 0.3}, 0.0, 0.0, degrees(120.0));

TEST(TrajectoryError, AMapThatIsOnlyTurnedAndShiftedIsRight) {
    std::vector<PosePair> pairs;
    for (int i = 0; i < 10; ++i) {
        const Pose pose = poseFrom({0.3 * i, 0.02 * i * i, 0.0}, 0.0, 0.0, 0.1 * i);
        pairs.push_back({pose, World * pose});
    }
    const auto error = trajectoryError(pairs);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->poses, 10);
    EXPECT_NEAR(error->position, 0.0, 1e-9);
    EXPECT_NEAR(error->rotation, 0.0, 1e-6);
    EXPECT_TRUE(error->mapInWorld.isApprox(World, 1e-9));
}

TEST(TrajectoryError, OneThatDroveStraightOrStoodHasAHeadingToo) {
    const Pose pose = poseFrom({1.0, 0.0, 0.0}, 0.0, 0.0, degrees(30.0));
    const std::vector<PosePair> one = {{pose, World * pose}};
    ASSERT_TRUE(trajectoryError(one));
    EXPECT_TRUE(trajectoryError(one)->mapInWorld.isApprox(World, 1e-9));
    EXPECT_FALSE(trajectoryError({}));
}

TEST(TrajectoryError, IsTheRootMeanSquareOfWhatIsLeft) {
    std::vector<PosePair> pairs;
    for (int i = 0; i < 40; ++i) {
        const Pose pose = poseFrom({std::cos(0.3 * i), 3.0 * std::sin(0.3 * i), 0.0}, 0.0, 0.0, 0.0);
        const double up = i % 2 == 0 ? 0.1 : -0.1, tilt = i % 2 == 0 ? 0.05 : -0.05;
        pairs.push_back(
            {poseFrom({0, 0, up}, 0, 0, 0) * pose * poseFrom({0, 0, 0}, tilt, 0, 0), World * pose});
    }
    const auto error = trajectoryError(pairs);
    ASSERT_TRUE(error);
    EXPECT_NEAR(error->position, 0.1, 1e-9);
    EXPECT_NEAR(error->rotation, 0.05, 1e-6);
}

TEST(TrajectoryError, PairsAreInterpolatedAndThoseFarFromTheTruthAreLeftOut) {
    const std::vector<StampedPose> truth = {{at(0.0), poseFrom({0, 0, 0}, 0, 0, 0)},
                                            {at(0.2), poseFrom({2, 0, 0}, 0, 0, 0)},
                                            {at(9.0), poseFrom({9, 0, 0}, 0, 0, 0)}};
    const Pose here = Pose::Identity();
    const std::vector<StampedPose> estimated = {{at(-1.0), here}, {at(0.0), here}, {at(0.05), here},
                                                {at(5.0), here},  {at(9.0), here}, {at(9.1), here}};
    const auto pairs = pairsOf(estimated, truth);
    ASSERT_THAT(pairs, SizeIs(3));
    EXPECT_NEAR(pairs[0].truth.translation().x(), 0.0, 1e-9);
    EXPECT_NEAR(pairs[1].truth.translation().x(), 0.5, 1e-6);
    EXPECT_NEAR(pairs[2].truth.translation().x(), 9.0, 1e-9);
    EXPECT_TRUE(pairsOf(estimated, {}).empty());
}

}  // namespace
}  // namespace leitstand
