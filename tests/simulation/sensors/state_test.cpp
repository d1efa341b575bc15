#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "robots/simulation/sensors/state/battery.h"
#include "robots/simulation/sensors/state/bumpers.h"
#include "robots/simulation/sensors/state/diagnostics.h"
#include "robots/simulation/sensors/state/gas_sensor.h"
#include "robots/simulation/sensors/state/wheel_odometry.h"
#include "tests/simulation/sensors/room.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

template <class Kind>
std::vector<Kind> allOf(const std::vector<HardwareSample>& samples) {
    std::vector<Kind> found;
    for (const HardwareSample& sample : samples) {
        if (const auto* one = sample.sample.as<Kind>()) found.push_back(*one);
    }
    return found;
}

template <class... Sensors>
std::vector<HardwareSample> runFor(World& world, int robot, std::chrono::nanoseconds time,
                                   Sensors&... sensors) {
    std::vector<HardwareSample> samples;
    for (const Time end = world.now() + time; world.now() < end;) {
        world.advance(20ms);
        (sensors.run(world, robot, samples), ...);
    }
    return samples;
}

TEST(Gas, FollowsItsSurroundingsWithALagOfTenSeconds) {
    GasLag lag(10.0, 400.0);
    for (int i = 0; i < 20; ++i) lag.step(1400.0, 0.5);
    EXPECT_NEAR(lag.value(), 400.0 + 1000.0 * (1.0 - std::exp(-1.0)), 1e-6) << "63 % after 10 s";
    for (int i = 0; i < 40; ++i) lag.step(1400.0, 0.5);
    EXPECT_NEAR(lag.value(), 400.0 + 1000.0 * (1.0 - std::exp(-3.0)), 1e-6);
    GasLag once(10.0, 400.0);
    EXPECT_NEAR(once.step(1400.0, 30.0), lag.value(), 1e-6) << "whatever the step";
}

TEST(Gas, FallsWithTheDistanceAndBehindWalls) {
    const GasSettings settings;
    EXPECT_NEAR(plumeShare(settings, 0.4, true), 0.5, 1e-12);
    EXPECT_GT(plumeShare(settings, 0.5, true), plumeShare(settings, 1.0, true));
    EXPECT_LT(plumeShare(settings, 1.0, false), 0.2 * plumeShare(settings, 1.0, true));
    EXPECT_EQ(plumeShare(settings, 5.0, true), 0.0);
}

TEST(Gas, TellsTheBreathOfAVictimInSight) {
    for (const bool wall : {false, true}) {
        RoomBuilder room;
        room.walls(4, 3, 2);
        room.victim({1.2, 0.0, 0.3}, 4000.0);
        if (wall) room.box(room.surface(Material::Plaster), {0.5, -1, 0}, {0.55, 1, 1.2});
        const auto world = room.world();
        const int robot = addBareRobot(*world);
        GasSettings settings;
        settings.sensorInBase.translation() << 0.2, 0.0, 0.3;
        GasSensor sensor(settings, Noise(1, "gas"), world->now());
        const auto samples = allOf<GasSample>(runFor(*world, robot, 60s, sensor));
        ASSERT_NEAR(double(samples.size()), 60.0, 1.0);
        const double steady = 400.0 + 4000.0 * (wall ? 0.15 : 1.0) / (1.0 + 1.0 / 0.16);
        EXPECT_NEAR(sensor.concentration(*world, robot, {0.2, 0.0, 0.3}), steady, 0.5);
        const auto meanOf = [&](std::size_t from, std::size_t to) {
            double sum = 0;
            for (std::size_t i = from; i < to; ++i) sum += samples[i].ppm / double(to - from);
            return sum;
        };
        EXPECT_NEAR(meanOf(50, 59), steady, 0.03 * steady);
        EXPECT_NEAR(meanOf(9, 12), 400.0 + (steady - 400.0) * (1.0 - std::exp(-1.05)), 0.06 * steady);
    }
}

TEST(Odometry, StepsAlongTheAttitude) {
    DeadReckoning reckoning;
    MeasuredAttitude attitude;
    for (int i = 0; i < 100; ++i) reckoning.step(0.01, 0.01, attitude);
    EXPECT_TRUE(reckoning.pose().translation().isApprox(Eigen::Vector3d(1, 0, 0), 1e-9));
    attitude.heading = degrees(90);
    reckoning.step(-0.001, 0.001, attitude);
    attitude.pitch = -degrees(30);
    for (int i = 0; i < 100; ++i) reckoning.step(0.01, 0.01, attitude);
    EXPECT_TRUE(reckoning.pose().translation().isApprox(Eigen::Vector3d(1, std::cos(degrees(30)), 0.5), 1e-6))
        << reckoning.pose().translation().transpose() << ": uphill";
    const Pose before = reckoning.pose();
    attitude.heading = degrees(120);
    reckoning.step(0.0, 0.0, attitude);
    EXPECT_TRUE(reckoning.pose().isApprox(before, 1e-9)) << "wheels stand: the heading holds";
    EXPECT_NEAR(reckoning.distance(), 2.001, 1e-9);
}

TEST(Odometry, DriftsWithinItsBounds) {
    // docs/simulation.md, "Sensors": 8 % of the way, 2 degrees and 0.5 degrees a metre, 95 % of drives.
    int within = 0, standing = 0;
    constexpr int Drives = 20;
    for (int drive = 0; drive < Drives; ++drive) {
        RoomBuilder room;
        room.walls(9, 9, 1);
        const auto world = room.world(static_cast<std::uint64_t>(drive + 1));
        const int robot = addBareRobot(*world, -6, -6, degrees(30));
        const Pose start = world->state(robot).baseInArena;
        InertialUnit unit({}, Noise(static_cast<std::uint64_t>(drive), "imu"), world->now());
        WheelOdometry odometry({}, unit, world->now());
        world->setMotors(robot, 0.7, 0.8);
        auto samples = runFor(*world, robot, 15s, unit, odometry);
        world->setMotors(robot, 0.8, 0.7);
        samples = runFor(*world, robot, 15s, unit, odometry);
        const OdometrySample last = allOf<OdometrySample>(samples).back();
        const Pose moved = start.inverse() * world->baseInArena(robot, last.header.stamp);
        const double way = last.baseInOdom.translation().norm();
        EXPECT_GT(way, 5.0);
        const double off = distanceBetween(moved, last.baseInOdom);
        const double turned = angleBetween(moved, last.baseInOdom);
        within += off < 0.08 * way && turned < degrees(2.0 + 0.5 * way) ? 1 : 0;

        world->setMotors(robot, 0.0, 0.0);
        world->setBrake(robot, true);
        samples = runFor(*world, robot, 2s, unit, odometry);
        const auto rest = allOf<OdometrySample>(runFor(*world, robot, 1s, unit, odometry));
        standing += rest.back().linear.isZero() && rest.back().angular.isZero() &&
                            rest.front().baseInOdom.translation() == rest.back().baseInOdom.translation()
                        ? 1
                        : 0;
    }
    EXPECT_GE(within, Drives * 95 / 100);
    EXPECT_EQ(standing, Drives) << "a robot that stands says zero";
}

TEST(Inertial, HoldsTheLevelAndDriftsInHeadingOnly) {
    RoomBuilder room;
    room.walls(9, 9, 1);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    InertialUnit unit({}, Noise(4, "imu"), world->now());
    world->setMotors(robot, -0.5, 0.5);
    double turned = 0.0;
    double last = 0.0;
    const auto samples = allOf<ImuSample>(runFor(*world, robot, 60s, unit));
    EXPECT_NEAR(double(samples.size()), 1200.0, 1.0);
    double level = 0.0, gravity = 0.0;
    for (const ImuSample& sample : samples) {
        ASSERT_TRUE(sample.orientation && sample.angularVelocity && sample.linearAcceleration);
        const Eigen::Vector3d up = sample.orientation->inverse() * Eigen::Vector3d::UnitZ();
        level = std::max(level, std::acos(std::clamp(up.z(), -1.0, 1.0)));
        gravity += sample.linearAcceleration->z() / double(samples.size());
        const Eigen::Matrix3d r = sample.orientation->toRotationMatrix();
        const double yaw = std::atan2(r(1, 0), r(0, 0));
        turned += std::remainder(yaw - last, 2 * std::numbers::pi);
        last = yaw;
    }
    EXPECT_LT(level, degrees(2.0));
    EXPECT_NEAR(gravity, 9.81, 0.1);
    double truly = 0.0;
    EXPECT_GT(turned, 1.0);
    const Eigen::Matrix3d r = world->state(robot).baseInArena.linear();
    truly = std::atan2(r(1, 0), r(0, 0));
    EXPECT_LT(std::abs(std::remainder(turned - truly, 2 * std::numbers::pi)), 0.02 * turned + degrees(4));
}

TEST(Inertial, ItsHeadingDriftsAsFarAsItsGyroSays) {
    // docs/simulation.md, "Sensors": 0.02 degrees/s at the start, walks by 0.002 degrees/s each root second.
    RoomBuilder room;
    room.walls(9, 9, 1);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    std::vector<InertialUnit> units;
    constexpr int Units = 60;
    for (std::uint64_t i = 0; i < Units; ++i)
        units.emplace_back(InertialSettings{}, Noise(i, "imu"), world->now());
    std::vector<HardwareSample> samples;
    constexpr double Seconds = 60.0;
    while (world->seconds() < Seconds) {
        world->advance(500ms);
        samples.clear();
        for (InertialUnit& unit : units) unit.run(*world, robot, samples);
    }
    const double expected = std::hypot(0.02 * Seconds, 0.002 * std::sqrt(std::pow(Seconds, 3) / 3.0));
    double squares = 0.0, worst = 0.0;
    for (const InertialUnit& unit : units) {
        const double drift = inDegrees(unit.attitudes().back().heading);
        squares += drift * drift / Units;
        worst = std::max(worst, std::abs(drift));
    }
    std::printf("a gyro that stands drifts by %.2f degrees in a minute (rms), %.2f at worst; %.2f expected\n",
                std::sqrt(squares), worst, expected);
    EXPECT_NEAR(std::sqrt(squares), expected, 0.3 * expected);
    EXPECT_LT(worst, 4.0 * expected);
}

TEST(Inertial, MeasuresTheSameHoweverItIsAsked) {
    std::vector<double> headings;
    for (const auto step : {5ms, 50ms}) {
        RoomBuilder room;
        room.walls(9, 9, 1);
        const auto world = room.world();
        const int robot = addBareRobot(*world);
        InertialUnit unit({}, Noise(4, "imu"), world->now());
        world->setMotors(robot, 0.2, 0.6);
        std::vector<HardwareSample> samples;
        while (world->seconds() < 10.0) {
            world->advance(step);
            unit.run(*world, robot, samples);
        }
        headings.push_back(unit.attitudes().back().heading);
    }
    EXPECT_NEAR(headings[0], headings[1], 1e-9);
}

TEST(Battery, RunsDownWithWhatIsDrawn) {
    RoomBuilder room;
    room.walls(9, 9, 1);
    const auto world = room.world();
    const int robot = addBareRobot(*world);
    Battery battery(kurt3dBattery(), Noise(1, "battery"), world->now());
    const auto idle = allOf<BatterySample>(runFor(*world, robot, 10s, battery));
    ASSERT_EQ(idle.size(), 11U);
    EXPECT_NEAR(idle.front().charge - idle.back().charge, 3.0 * 10 / 3600, 1e-4);
    world->setMotors(robot, 0.8, -0.8);
    const auto driving = allOf<BatterySample>(runFor(*world, robot, 10s, battery));
    EXPECT_LT(driving.back().voltage, idle.back().voltage);
    EXPECT_LT(driving.back().current, -4.0);
    EXPECT_GT(driving.back().fraction, 0.9);
    EXPECT_EQ(driving.back().status, BatterySample::Status::Discharging);
}

TEST(Bumpers, TellWhereTheRobotWasHitAndThatItIsFreeAgain) {
    RoomBuilder room;
    room.walls(2, 2, 1);
    const auto world = room.world();
    const int robot = addBareRobot(*world, 1.0, 0.0, 0.0);
    Bumpers bumpers("kurt3d/base_link");
    Diagnostics diagnostics("kurt3d", world->now());
    auto samples = allOf<BumpSample>(runFor(*world, robot, 1s, bumpers));
    ASSERT_EQ(samples.size(), 1U) << "told once, then on change";
    EXPECT_EQ(samples[0].bumpers.size(), 4U);
    world->setMotors(robot, 0.6, 0.6);
    samples = allOf<BumpSample>(runFor(*world, robot, 4s, bumpers, diagnostics));
    ASSERT_FALSE(samples.empty());
    EXPECT_EQ(samples.back().bumpers[0].name, "front");
    EXPECT_EQ(samples.back().bumpers[0].hits, 1U);
    EXPECT_TRUE(samples.back().bumpers[0].pressed);
    EXPECT_EQ(samples.back().bumpers[2].hits, 0U);
    world->setMotors(robot, -0.6, -0.6);
    samples = allOf<BumpSample>(runFor(*world, robot, 1s, bumpers));
    ASSERT_FALSE(samples.empty());
    EXPECT_FALSE(samples.back().bumpers[0].pressed);
    EXPECT_EQ(samples.back().bumpers[0].hits, 1U);
}

}  // namespace
}  // namespace leitstand::simulation::test
