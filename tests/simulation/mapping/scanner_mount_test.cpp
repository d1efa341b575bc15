#include <cstdio>

#include <gtest/gtest.h>

#include "tests/simulation/mapping/building_sets.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Least = 40.0;  ///< way that a mount shows on [m]

void print(std::uint64_t seed, double way, const ScannerCalibration& calibration) {
    const MountError reported = calibration.mount.value_or(MountError());
    const Eigen::Vector4d &is = reported.value, &off = reported.deviation;
    std::printf(
        "%llu: %.0f m: x %.1f (%.1f) mm, y %.1f (%.1f) mm, heading %.2f (%.2f) degrees, clock %.1f (%.1f) "
        "ms\n",
        static_cast<unsigned long long>(seed), way, 1e3 * is[0], 1e3 * off[0], 1e3 * is[1], 1e3 * off[1],
        inDegrees(is[2]), inDegrees(off[2]), 1e3 * is[3], 1e3 * off[3]);
}

/// Driven in an eight through a building of 30 x 20 m; what the map advises is used.
MappedDrive corrected(const SensorErrors& sensor, const OdometryErrors& odometry, std::uint64_t seed) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    const Building building = std::move(generateBuilding(settings, seed)).value();
    const DrivePath path(eightRoute(building.ways, 4));
    ScriptSettings script;
    script.seed = seed;
    script.sensor = sensor;
    script.odometry = odometry;
    ScriptedDrive made = scriptedDrive(building.arena, path, script);
    LiveSettings mapping;
    mapping.loops.on = true;
    MappedDrive result =
        mapped(made.drive, std::move(made.scans), mapping, [&](const ScannerCorrection& more) {
            ScriptSettings better = script;
            better.correction = more;
            return scriptedDrive(building.arena, path, better).scans;
        });
    print(seed, made.drive.way, result.calibration);
    EXPECT_GT(made.drive.way, Least);
    return result;
}

class ScannerMountLong : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ScannerMountLong, OneThatSitsAsItIsSaidIsNotAskedAbout) {
    EXPECT_EQ(corrected({}, {}, GetParam()).corrections, 0);
    OdometryErrors bad;
    bad.scale = 0.06;
    bad.headingBias *= 10;
    bad.headingNoise *= 4;
    EXPECT_EQ(corrected({}, bad, GetParam()).corrections, 0) << "what odometry is off by is no mount";
}

TEST_P(ScannerMountLong, OneThatSitsOtherwiseIsCorrected) {
    SensorErrors sensor;
    sensor.mountShift = {0.025, -0.03, 0.0};
    sensor.mountTurn.z() = degrees(0.8);
    const ScannerCorrection found = corrected(sensor, {}, GetParam()).correction;
    EXPECT_NEAR(found.x, 0.025, 0.01);
    EXPECT_NEAR(found.y, -0.03, 0.01);
    EXPECT_NEAR(found.yaw, degrees(0.8), degrees(0.15));
    EXPECT_EQ(found.clock, 0.0);
    EXPECT_EQ(found.range, 0.0);
}

TEST_P(ScannerMountLong, OneThatIsLateIsCorrected) {
    SensorErrors sensor;
    sensor.clockLate = 0.06;
    const ScannerCorrection found = corrected(sensor, {}, GetParam()).correction;
    EXPECT_NEAR(found.clock, -0.06, 0.012);
    EXPECT_NEAR(found.yaw, 0.0, degrees(0.15));
    EXPECT_EQ(found.range, 0.0);
}

TEST_P(ScannerMountLong, ARobotThatSlipsInArenasIsNotAskedAbout) {
    const RecordedDrive drive = exploredYellow(GetParam(), 300.0);
    LiveSettings mapping;
    mapping.loops.on = true;
    const MappedDrive result = mapped(drive, cutScans(drive), mapping);
    print(GetParam(), drive.way, result.calibration);
    EXPECT_GT(drive.way, Least);
    EXPECT_EQ(result.calibration.advised(), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Measured, ScannerMountLong, testing::Values(931, 932, 933));

}  // namespace
}  // namespace leitstand::simulation::test
