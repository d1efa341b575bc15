#include "core/cloud/pose_track.h"

#include <limits>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using std::chrono::milliseconds;

Time at(int ms) {
    return Time(milliseconds(ms));
}

TEST(PoseTrack, LiesBetweenTheTwoPosesAround) {
    PoseTrack track;
    track.add(at(1100), poseFrom({1, 0, 0}, 0, 0, degrees(40)));
    track.add(at(1000), poseFrom({0, 0, 0}, 0, 0, 0));  // came late
    const auto pose = track.at(at(1025));
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->isApprox(poseFrom({0.25, 0, 0}, 0, 0, degrees(10)), 1e-12));
}

TEST(PoseTrack, DoesNotGuessAcrossGaps) {
    PoseTrack track;
    EXPECT_FALSE(track.at(at(0)));
    track.add(at(0), poseFrom({1, 0, 0}, 0, 0, 0));
    track.add(at(5000), poseFrom({9, 0, 0}, 0, 0, 0));
    EXPECT_FALSE(track.at(at(2500)));
    EXPECT_FALSE(track.at(at(-501)));
    EXPECT_NEAR(track.at(at(400))->translation().x(), 1.0, 1e-12);
    EXPECT_NEAR(track.at(at(4600))->translation().x(), 9.0, 1e-12);
    EXPECT_NEAR(track.at(at(5500))->translation().x(), 9.0, 1e-12);
}

TEST(PoseTrack, KeepsNothingThatIsNotFinite) {
    PoseTrack track;
    track.add(at(0), poseFrom({std::numeric_limits<double>::quiet_NaN(), 0, 0}, 0, 0, 0));
    EXPECT_TRUE(track.empty());
}

}  // namespace
}  // namespace leitstand::test
