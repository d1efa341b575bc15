#include "widgets/map_view/robots/follow_camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/widgets/map_live/live_map.h"

namespace leitstand::test {
namespace {

constexpr double Tick = 0.033;  ///< [s]

TEST(FollowCamera, StandsBehindAndAboveTheRobotAndLooksAhead) {
    FollowCamera follow;
    follow.start(MapFollow::Behind, false);
    EXPECT_FALSE(follow.aimed());
    EXPECT_TRUE(follow.aim(onFloor(3, 1, degrees(90)), 0));
    const MapCamera& camera = follow.camera();
    EXPECT_LT(camera.eye().y(), 1.0 - 1.0) << "behind";
    EXPECT_GT(camera.eye().z(), RoomFloor + 1.0) << "above";
    EXPECT_NEAR(camera.eye().x(), 3.0, 1e-9);
    EXPECT_NEAR(camera.yaw, degrees(90), 1e-9);
}

TEST(FollowCamera, FromAboveTheHeadingIsUp) {
    FollowCamera follow;
    for (const bool parallel : {false, true}) {
        follow.start(MapFollow::Above, parallel);
        (void)follow.aim(onFloor(0, 0, degrees(-130)), 0);
        const Eigen::Vector3d ahead(std::cos(degrees(-130)), std::sin(degrees(-130)), 0);
        EXPECT_TRUE(follow.camera().up().isApprox(ahead, 1e-9));
        EXPECT_EQ(follow.camera().parallel, parallel);
    }
}

TEST(FollowCamera, GlidesAfterTheRobotAndComesToRest) {
    FollowCamera follow;
    follow.start(MapFollow::Behind, false);
    (void)follow.aim(onFloor(0, 0, 0), 0);
    const MapCamera before = follow.camera();
    EXPECT_TRUE(follow.aim(onFloor(0.5, 0, degrees(40)), Tick));
    EXPECT_GT(follow.camera().yaw, 0.0);
    EXPECT_LT(follow.camera().yaw, degrees(10)) << "smooth";
    int ticks = 0;
    while (follow.aim(onFloor(0.5, 0, degrees(40)), Tick) && ticks < 300) ++ticks;
    EXPECT_LT(ticks, 100);
    EXPECT_NEAR(follow.camera().yaw, degrees(40), 1e-3);
    EXPECT_GT((follow.camera().focus - before.focus).norm(), 0.3);
}

TEST(FollowCamera, TurnsTheShortWayAcrossTheBack) {
    FollowCamera follow;
    follow.start(MapFollow::Above, true);
    (void)follow.aim(onFloor(0, 0, degrees(175)), 0);
    (void)follow.aim(onFloor(0, 0, degrees(-175)), Tick);
    EXPECT_GT(std::abs(follow.camera().yaw), degrees(170));
}

TEST(FollowCamera, StandsStillWhileARobotOnlyTrembles) {
    FollowCamera follow;
    follow.start(MapFollow::Behind, false);
    (void)follow.aim(onFloor(0, 0, 0), 0);
    while (follow.aim(onFloor(0, 0, 0), Tick)) {
    }
    for (int i = 0; i < 20; ++i) EXPECT_FALSE(follow.aim(onFloor(0.003 * (i % 2), 0, degrees(0.1)), Tick));
}

TEST(FollowCamera, KeepsWhatTheOperatorChanged) {
    FollowCamera follow;
    follow.start(MapFollow::Behind, false);
    (void)follow.aim(onFloor(0, 0, 0), 0);
    MapCamera turned = follow.camera();
    turned.yaw += degrees(30);
    turned.distance *= 2;
    follow.adjust(turned);
    EXPECT_NEAR(follow.camera().yaw, degrees(30), 1e-9);
    (void)follow.aim(onFloor(50, 0, degrees(90)), Tick);  // far away: jumps
    EXPECT_NEAR(follow.camera().yaw, degrees(120), 1e-9);
    EXPECT_NEAR(follow.camera().distance, turned.distance, 1e-9);
}

}  // namespace
}  // namespace leitstand::test
