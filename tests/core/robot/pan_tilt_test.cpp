#include "core/robot/control/pan_tilt.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace leitstand {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

const SteadyTime Begin = SteadyTime(100s);
const PanTiltMount Mount{"left", degrees(100), degrees(60), degrees(50)};

/// @p optical, a direction of the camera at @p angles, in the frame in which its unit stands.
Vector3d inBase(const PanTiltAngles& angles, const Vector3d& optical) {
    const Vector3d upright(optical.z(), -optical.x(), -optical.y());
    return Eigen::AngleAxisd(angles.pan, Vector3d::UnitZ()) *
           (Eigen::AngleAxisd(angles.tilt, Vector3d::UnitY()) * upright.normalized());
}

TEST(PanTilt, AThingStaysUnderThePointerThatDragsIt) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-0.5, 0.5), place(-0.5, 0.5);
    for (int i = 0; i < 200; ++i) {
        const PanTiltAngles start{angle(random), angle(random)};
        const Vector3d grabbed(place(random), place(random), 1.0), pointer(place(random), place(random), 1.0);
        const PanTiltAngles end = dragged(start, grabbed, pointer);
        EXPECT_LT((inBase(start, grabbed) - inBase(end, pointer)).norm(), 1e-9) << i;
    }
}

TEST(PanTilt, LooksTowardsADirection) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const Vector3d direction(part(random), part(random), part(random));
        EXPECT_LT((inBase(towards(direction), {0, 0, 1}) - direction.normalized()).norm(), 1e-9) << i;
    }
    EXPECT_GT(towards({1.0, 0.0, -0.3}).tilt, 0.0) << "down";
    EXPECT_GT(towards({1.0, 0.3, 0.0}).pan, 0.0) << "to the left";
}

TEST(PanTilt, DraggingToTheRightLooksToTheLeftAndDownLooksUp) {
    const PanTiltAngles right = dragged({}, {0, 0, 1}, {0.2, 0, 1});
    EXPECT_NEAR(right.pan, std::atan(0.2), 1e-9);
    EXPECT_NEAR(right.tilt, 0.0, 1e-9);
    const PanTiltAngles down = dragged({}, {0, 0, 1}, {0, 0.2, 1});
    EXPECT_NEAR(down.tilt, -std::atan(0.2), 1e-9);
    EXPECT_EQ(dragged({0.3, 0.1}, {0, 0, 1}, {0, 0, 1}).pan, 0.3) << "a click moves nothing";
}

TEST(PanTilt, IsCutToWhatTheUnitCanDo) {
    EXPECT_EQ(within(Mount, {9.0, 9.0}), (PanTiltAngles{Mount.pan, Mount.down}));
    EXPECT_EQ(within(Mount, {-9.0, -9.0}), (PanTiltAngles{-Mount.pan, -Mount.up}));
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(within(Mount, {none, none}), PanTiltAngles{});
}

TEST(PanTilt, AWishIsRepeatedUntilTheUnitIsThere) {
    PanTiltControl control(Mount);
    EXPECT_FALSE(control.due(Begin));
    control.turnTo({0.4, 0.1}, Begin);
    EXPECT_EQ(control.due(Begin), (PanTiltAngles{0.4, 0.1}));
    EXPECT_FALSE(control.due(Begin + 100ms)) << "said already";
    EXPECT_TRUE(control.due(Begin + 600ms)) << "it may not have been heard";
    control.reported({0.4, 0.1});
    EXPECT_FALSE(control.due(Begin + 700ms));
    EXPECT_FALSE(control.requested());
    control.turnBy({-0.1, 0.0}, Begin + 800ms);
    const auto then = control.due(Begin + 800ms);
    ASSERT_TRUE(then);
    EXPECT_NEAR(then->pan, 0.3, 1e-12);
}

TEST(PanTilt, AWishThatNothingComesOfIsDropped) {
    PanTiltControl control(Mount);
    control.turnTo({0.4, 0.0}, Begin);
    int sent = 0;
    for (auto time = Begin; time < Begin + 10s; time += 20ms) sent += control.due(time) ? 1 : 0;
    EXPECT_GE(sent, 8);
    EXPECT_LE(sent, 12);
    EXPECT_FALSE(control.requested());
}

TEST(PanTilt, TurnsAtARateWithinItsLimitsAndNotTooOften) {
    PanTiltControl control(Mount);
    control.reported({0.1, 0.0});
    control.setRate({1.0, 0.0}, Begin);
    int sent = 0;
    for (auto time = Begin; time < Begin + 1s; time += 5ms) sent += control.due(time) ? 1 : 0;
    EXPECT_LE(sent, 26);
    EXPECT_GE(sent, 20);
    EXPECT_NEAR(control.requested()->pan, 1.1, 0.01);
    control.setRate({}, Begin + 1s);
    (void)control.due(Begin + 1100ms);
    EXPECT_NEAR(control.requested()->pan, 1.1, 0.01) << "let go, it stays";
    control.setRate({1.0, 0.0}, Begin + 2s);
    for (auto time = Begin + 2s; time < Begin + 5s; time += 20ms) (void)control.due(time);
    EXPECT_NEAR(control.requested()->pan, Mount.pan, 1e-9);
    // After a pause it goes on, it does not jump.
    control.setRate({-1.0, 0.0}, Begin + 6s);
    (void)control.due(Begin + 60s);
    EXPECT_NEAR(control.requested()->pan, Mount.pan - 0.1, 1e-9);
}

}  // namespace
}  // namespace leitstand
