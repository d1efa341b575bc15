#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/mapping/motion/motion_buffer.h"
#include "core/perception/surroundings/robot_profile.h"
#include "core/perception/surroundings/virtual_scan.h"
#include "tests/simulation/drives/driven_world.h"
#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation::test {
namespace {

/// A robot in @p arena at its origin, and the virtual scan that a station makes of what it says.
class Watched {
public:
    Watched(const TestArena& arena, const std::string& kind)
        : world(arena.arena, arena.mesh,
                {.kind = kind, .seed = 1, .start = Pose::Identity(), .infrared = false}),
          m_robot(shippedRobot(kind)),
          m_scan(settingsFor(m_robot)) {
        world.onSample = [this](const HardwareSample& sample) { take(sample); };
        world.ask("teleoperation");
        world.drive(0.0, 0.0, 0.5);
    }

    /// How near things are to the body, ahead and then counter-clockwise in eighths [m].
    [[nodiscard]] std::array<double, 8> ring() const {
        std::array<double, 8> ring;
        ring.fill(std::numeric_limits<double>::infinity());
        const BodyBox box = body();
        for (const VirtualObstacle& one : m_scan.view(m_base, m_newest).obstacles) {
            const double eighths = std::atan2(one.where.y(), one.where.x()) / (std::numbers::pi / 4);
            const double x = std::max({one.where.x() - box.front, -box.back - one.where.x(), 0.0});
            const double y = std::max({one.where.y() - box.left, -box.right - one.where.y(), 0.0});
            double& part = ring[static_cast<std::size_t>((std::lround(eighths) + 8) % 8)];
            part = std::min(part, std::hypot(x, y));
        }
        return ring;
    }
    [[nodiscard]] BodyBox body() const { return boxAround(m_robot.footprint); }

    DrivenWorld world;

private:
    static VirtualScanSettings settingsFor(const RobotDescription& robot) {
        VirtualScanSettings settings;
        settings.body = boxAround(robot.footprint);
        settings.profile = profileOf(robot);
        return settings;
    }
    void take(const HardwareSample& sample) {
        if (const auto* odometry = sample.sample.as<OdometrySample>()) {
            m_motion.add(*odometry);
            m_base = odometry->baseInOdom;
            m_newest = odometry->header.stamp;
        }
        if (sample.sample.is<CloudSample>() || sample.sample.is<RangesSample>()) m_held.push_back(sample);
        // A turn waits until odometry covers it.
        constexpr std::chrono::milliseconds Longest(110);
        while (!m_held.empty() && m_motion.covers(stampOf(m_held.front()) + Longest)) {
            add(m_held.front());
            m_held.pop_front();
        }
    }
    static Time stampOf(const HardwareSample& sample) {
        if (const auto* cloud = sample.sample.as<CloudSample>()) return cloud->header.stamp;
        return sample.sample.get<RangesSample>().header.stamp;
    }
    void add(const HardwareSample& sample) {
        const auto at = [this](Time stamp) -> std::optional<Pose> {
            const auto there = m_motion.at(stamp);
            return there ? std::optional(there->baseInOdom) : std::nullopt;
        };
        if (const auto* cloud = sample.sample.as<CloudSample>()) {
            m_scan.add(*cloud, m_robot.sensors.at("scanner").sensorInBase, at);
        } else {
            m_scan.add(sample.sample.get<RangesSample>(), m_robot.sensors.at("laser").sensorInBase, at);
        }
    }

    RobotDescription m_robot;
    VirtualScan m_scan;
    MotionBuffer m_motion;
    Pose m_base = Pose::Identity();
    Time m_newest{};
    std::deque<HardwareSample> m_held;
};

class TiltedSight : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Robots, TiltedSight, testing::Values("kurt3d", "crawler"));

/// Drives ahead up a ramp of 14 degrees until base_link is at @p x [m].
void driveUp(Watched& robot, double x, const std::function<void()>& each = {}) {
    while (robot.world.place().x() < x) {
        robot.world.drive(0.3, 0.0, 0.25);
        ASSERT_LT(robot.world.world->seconds(), 20.0) << "it gets on";
        if (each && inDegrees(pitchOf(robot.world.state())) < -13.0) each();
    }
}

TEST_P(TiltedSight, ARampThatTheRobotIsOnIsNoObstacle) {
    TestArena arena;
    arena.ramp({1.0, 0, 0}, degrees(14), 2.0);
    Watched robot(arena, GetParam());
    int looks = 0;
    driveUp(robot, 2.7, [&] {
        ++looks;
        for (const double near : robot.ring()) EXPECT_GT(near, 0.05) << "at x = " << robot.world.place().x();
    });
    EXPECT_GT(looks, 10);
}

TEST_P(TiltedSight, TheWallAheadOnARampIsAnObstacle) {
    constexpr double Wall = 3.6;
    TestArena arena;
    arena.ramp({1.0, 0, 0}, degrees(14), 2.0);
    arena.box({Wall, -2, 0}, {Wall + 0.1, 2, 2});
    Watched robot(arena, GetParam());
    driveUp(robot, 2.7);
    const double ahead = Wall - robot.world.place().x() - robot.body().front;
    EXPECT_NEAR(robot.ring()[0], ahead, 0.1);
}

TEST_P(TiltedSight, WhatStandsBesideARampIsStillThere) {
    TestArena arena;
    arena.ramp({1.0, 0, 0}, degrees(14), 2.0, 0.8);
    for (const double side : {-1.0, 1.0})
        arena.box({0.5, side > 0 ? 0.42 : -0.52, 0}, {4.0, side > 0 ? 0.52 : -0.42, 1.6});
    Watched robot(arena, GetParam());
    driveUp(robot, 2.2);
    const double beside = 0.42 - robot.body().left;
    const auto ring = robot.ring();
    EXPECT_NEAR(std::min({ring[1], ring[2], ring[3]}), beside, 0.08);
    EXPECT_NEAR(std::min({ring[5], ring[6], ring[7]}), beside, 0.08);
}

}  // namespace
}  // namespace leitstand::simulation::test
