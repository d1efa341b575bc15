#include "robots/control/safe_teleoperation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/robots/control/test_ground.h"

namespace leitstand::test {
namespace {

SafeTeleoperationSettings settings() {
    SafeTeleoperationSettings settings;
    settings.body = TestGround::body();
    return settings;
}

/// Everything looked at @p age seconds ago, free but for @p obstacles.
VirtualScanView viewOf(double age, std::vector<VirtualObstacle> obstacles = {}) {
    VirtualScanView view;
    view.sectors.resize(180);
    for (auto& sector : view.sectors) sector.age = age;
    view.obstacles = std::move(obstacles);
    return view;
}

TEST(SafeTeleoperation, LetsTheOperatorDriveWhereItIsFreeAndFresh) {
    const SafeVelocity safe = safeVelocity({0.6, 0.0, 0.5}, viewOf(1.0), settings());
    EXPECT_DOUBLE_EQ(safe.share, 1.0);
    EXPECT_DOUBLE_EQ(safe.velocity.forward, 0.6);
    EXPECT_DOUBLE_EQ(safe.velocity.turn, 0.5);
    EXPECT_TRUE(safe.reason.empty());
}

TEST(SafeTeleoperation, SlowsDownOnTheSameCurveTheNearerSomethingIs) {
    double before = 1.0;
    for (double x = 1.8; x > 0.35; x -= 0.1) {
        const SafeVelocity safe = safeVelocity({0.6, 0.0, 0.3}, viewOf(0.5, {{{x, 0.0}, 0.5}}), settings());
        EXPECT_LE(safe.share, before + 1e-9) << x;
        EXPECT_NEAR(safe.velocity.turn * 0.6, safe.velocity.forward * 0.3, 1e-9);
        before = safe.share;
    }
    const SafeVelocity near = safeVelocity({0.6, 0.0, 0.0}, viewOf(0.5, {{{0.305, 0.0}, 0.5}}), settings());
    EXPECT_LT(near.velocity.forward, 0.12);
    EXPECT_EQ(near.reason.substr(0, 11), "obstacle in");
    EXPECT_DOUBLE_EQ(safeVelocity({-0.6, 0.0, 0.0}, viewOf(0.5, {{{0.305, 0.0}, 0.5}}), settings()).share,
                     1.0)
        << "away from it";
}

TEST(SafeTeleoperation, OldAndUnseenSectorsAllowOnlyCreeping) {
    const double full = safeVelocity({0.5, 0.0, 0.0}, viewOf(2.4), settings()).velocity.forward;
    const double older = safeVelocity({0.5, 0.0, 0.0}, viewOf(4.0), settings()).velocity.forward;
    const SafeVelocity old = safeVelocity({0.5, 0.0, 0.0}, viewOf(9.0), settings());
    const SafeVelocity never = safeVelocity({0.5, 0.0, 0.0}, viewOf(INFINITY), settings());
    EXPECT_DOUBLE_EQ(full, 0.5);
    EXPECT_LT(older, 0.4);
    EXPECT_GT(older, 0.1);
    EXPECT_NEAR(old.velocity.forward, 0.1, 1e-9);
    EXPECT_EQ(old.reason, "the scan there is 9.0 s old");
    EXPECT_NEAR(never.velocity.forward, 0.1, 1e-9);
    EXPECT_EQ(never.reason, "not seen there yet");
    EXPECT_NEAR(safeVelocity({0.05, 0.0, 0.0}, viewOf(9.0), settings()).velocity.forward, 0.05, 1e-9);
}

TEST(SafeTeleoperation, OnlyTheSectorsThatItDrivesIntoCount) {
    VirtualScanView view = viewOf(0.2);
    for (std::size_t i = 0; i < view.sectors.size(); ++i) {
        if (std::abs(view.directionOf(static_cast<int>(i))) > 2.0) view.sectors[i].age = 60.0;
    }
    EXPECT_DOUBLE_EQ(safeVelocity({0.5, 0.0, 0.0}, view, settings()).share, 1.0);
    EXPECT_LT(safeVelocity({-0.5, 0.0, 0.0}, view, settings()).share, 0.25);
}

TEST(SafeTeleoperation, NothingFollowsOfWhatIsNoNumber) {
    EXPECT_TRUE(isZero(safeVelocity({std::nan(""), 0.0, 0.0}, viewOf(0.1), settings()).velocity));
    EXPECT_TRUE(isZero(safeVelocity({}, viewOf(0.1), settings()).velocity));
}

TEST(SafeTeleoperation, FullAheadAtAWallStopsBeforeIt) {
    for (const double yaw : {0.0, 0.4, -0.7, 3.0}) {
        for (const double turn : {0.0, 0.4, -0.8}) {
            TestGround ground(maze({"+-+-+", "|   |", "+ + +", "|   |", "+-+-+"}, 2.0));
            ground.place(1.8, 1.8, yaw);
            while (ground.seconds() < 3.0) ground.step({});
            while (ground.seconds() < 25.0) {
                const DriveVelocity requested{0.6, 0.0, turn};
                ground.step(safeVelocity(requested, ground.view(), settings()).velocity);
            }
            EXPECT_EQ(ground.touches(), 0) << yaw << " " << turn;
            if (turn == 0.0) {
                EXPECT_LT(ground.distance(ground.baseInGround().translation().head<2>()), 0.55)
                    << yaw << ": it gets near";
            }
        }
    }
}

}  // namespace
}  // namespace leitstand::test
