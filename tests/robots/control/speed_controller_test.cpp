#include "robots/control/speed_controller.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/pose.h"
#include "robots/control/drive_kinematics.h"

namespace leitstand::test {
namespace {

constexpr double Step = 0.01;  // the agents' control loop runs at 100 Hz

/// One side of a robot on a motor whose force falls from stall to nothing at full speed.
struct Side {
    double mass = 3.5;         ///< half the robot [kg]
    double stallForce = 60.0;  ///< [N]
    double fullSpeed = 0.7;    ///< [m/s]
    double inertia = 4.0;      ///< [kg]
    double slope = 0.0;        ///< [rad]
    bool stalled = false;
    double speed = 0.0;

    void run(double voltage) {
        for (int i = 0; i < 10; ++i) {
            double force = stallForce * (voltage - speed / fullSpeed) - mass * 9.81 * std::sin(slope);
            const double friction = 0.02 * mass * 9.81;
            force -= std::clamp(speed / 0.01, -1.0, 1.0) * friction;
            speed = stalled ? 0.0 : speed + force / (mass + inertia) * 0.1 * Step;
        }
    }
};

Side crawler() {
    return {};
}
Side kurt3d() {
    return {12.5, 160.0, 0.75, 6.0};
}

SpeedControllerSettings settingsFor(const Side& side) {
    SpeedControllerSettings settings;
    settings.fullSpeed = side.fullSpeed;
    return settings;
}

struct Response {
    double settled = 0.0, overshoot = 0.0;
    double last = 0.0;
};

Response respond(Side& side, SpeedController& controller, double wanted, double seconds) {
    Response response;
    const double from = side.speed;
    for (int i = 1; i * Step <= seconds; ++i) {
        side.run(controller.step(wanted, side.speed, Step));
        const double done = (side.speed - from) / (wanted - from);
        response.overshoot = std::max(response.overshoot, done - 1.0);
        if (std::abs(done - 1.0) > 0.05) response.settled = i * Step;
    }
    response.last = side.speed;
    return response;
}

TEST(SpeedController, SettlesWithinThreeTenthsOfASecondWithLittleOvershoot) {
    for (Side side : {crawler(), kurt3d()}) {
        for (const double wanted : {0.1, 0.2, 0.3, 0.5, -0.3}) {
            side.speed = 0.0;
            SpeedController controller(settingsFor(side));
            const Response response = respond(side, controller, wanted, 1.0);
            std::printf("%.1f kg to %.1f m/s: settles in %.2f s, overshoot %.1f %%\n", side.mass, wanted,
                        response.settled, 100.0 * response.overshoot);
            EXPECT_LE(response.settled, 0.3) << wanted;
            EXPECT_LT(response.overshoot, 0.10) << wanted;
        }
    }
}

TEST(SpeedController, HoldsItsSpeedOnARampOfThirtyDegrees) {
    for (Side side : {crawler(), kurt3d()}) {
        side.slope = degrees(30);
        SpeedController controller(settingsFor(side));
        EXPECT_NEAR(respond(side, controller, 0.2, 1.5).last, 0.2, 0.01);
        EXPECT_NEAR(respond(side, controller, 0.0, 1.5).last, 0.0, 0.01) << "stands on it, too";
        EXPECT_NEAR(respond(side, controller, -0.2, 1.5).last, -0.2, 0.01);
    }
}

TEST(SpeedController, LeavesNothingBehindAfterAStall) {
    for (Side side : {crawler(), kurt3d()}) {
        SpeedController controller(settingsFor(side));
        side.stalled = true;
        for (int i = 0; i < 500; ++i) side.run(controller.step(0.3, side.speed, Step));
        side.stalled = false;
        double most = 0.0;
        int outside = 0;
        for (int i = 0; i < 100; ++i) {
            side.run(controller.step(0.3, side.speed, Step));
            most = std::max(most, side.speed);
            if (std::abs(side.speed - 0.3) > 0.015) outside = i;
        }
        EXPECT_LT(most, 0.3 * 1.25) << side.mass;
        EXPECT_LT(outside, 60) << side.mass;
        // ... and to the other side at once.
        side.stalled = true;
        for (int i = 0; i < 500; ++i) side.run(controller.step(0.5, side.speed, Step));
        side.stalled = false;
        for (int i = 0; i < 60; ++i) side.run(controller.step(-0.3, side.speed, Step));
        EXPECT_NEAR(side.speed, -0.3, 0.03) << side.mass;
    }
}

TEST(SpeedController, AsksForNothingWhenSomethingIsNoNumber) {
    SpeedController controller(SpeedControllerSettings{});
    EXPECT_EQ(controller.step(std::nan(""), 0.1, 0.01), 0.0);
    EXPECT_EQ(controller.step(0.1, INFINITY, 0.01), 0.0);
    EXPECT_EQ(controller.step(0.1, 0.1, 0.0), 0.0);
    EXPECT_LE(std::abs(controller.step(100.0, 0.0, 10.0)), 1.0);
}

TEST(DriveKinematics, ThereAndBack) {
    const DriveGeometry geometry{0.4, 0.6};
    const SideSpeeds sides = sidesFor({0.3, 0.0, 0.5}, geometry);
    EXPECT_DOUBLE_EQ(sides.left, 0.2);
    EXPECT_DOUBLE_EQ(sides.right, 0.4);
    const DriveVelocity back = velocityOf(sides, geometry);
    EXPECT_DOUBLE_EQ(back.forward, 0.3);
    EXPECT_DOUBLE_EQ(back.turn, 0.5);
}

TEST(DriveKinematics, LimitsKeepTheCurve) {
    const DriveGeometry geometry{0.4, 0.6};
    for (const DriveVelocity& requested : {DriveVelocity{1.0, 0.0, 2.0}, DriveVelocity{-0.6, 0.0, 1.0},
                                           DriveVelocity{0.0, 0.0, 9.0}, DriveVelocity{0.6, 0.0, -0.2}}) {
        const SideSpeeds sides = sidesFor(requested, geometry);
        EXPECT_NEAR(std::max(std::abs(sides.left), std::abs(sides.right)), 0.6, 1e-12);
        const DriveVelocity driven = velocityOf(sides, geometry);
        EXPECT_NEAR(driven.forward * requested.turn, driven.turn * requested.forward, 1e-9)
            << "same curvature";
        EXPECT_GE(driven.forward * requested.forward, 0.0);
    }
    const SideSpeeds none = sidesFor({std::nan(""), 0.0, 0.0}, geometry);
    EXPECT_EQ(none.left, 0.0);
    EXPECT_EQ(none.right, 0.0);
}

}  // namespace
}  // namespace leitstand::test
