#include "robots/agent/odometry_track.h"

#include <chrono>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

Time at(int ms) {
    return Time(std::chrono::seconds(100) + std::chrono::milliseconds(ms));
}

TEST(OdometryTrack, BeyondTheNewestARobotThatTurnsGoesOnTurning) {
    const auto turning = [](int ms) { return poseFrom({0.5e-3 * ms, 0, 0}, 0, 0, degrees(0.09) * ms); };
    OdometryTrack track;
    EXPECT_FALSE(track.at(at(0)));
    track.add(at(0), turning(0));
    EXPECT_LT(angleBetween(track.at(at(100)).value(), turning(0)), 1e-9) << "nobody knows how it moves";
    for (int ms = 20; ms <= 1000; ms += 20) track.add(at(ms), turning(ms));
    for (const int ms : {510, 1000, 1050, 1250}) {
        const auto there = track.at(at(ms));
        ASSERT_TRUE(there) << ms;
        EXPECT_LT(angleBetween(*there, turning(ms)), degrees(0.1)) << ms;
        EXPECT_LT(distanceBetween(*there, turning(ms)), 0.001) << ms;
    }
    EXPECT_FALSE(track.at(at(1350))) << "too far ahead";
}

}  // namespace
}  // namespace leitstand::test
