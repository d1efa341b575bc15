#include "tests/simulation/mapping/scripted_drive.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/mapping/building_sets.h"
#include "tests/simulation/mapping/near_surfaces.h"

namespace leitstand::simulation::test {
namespace {

Building building(bool smooth, int storeys = 1) {
    BuildingSettings settings;
    settings.smooth = smooth;
    settings.storeys = storeys;
    return std::move(generateBuilding(settings, 1)).value();
}

/// @p way along the southern corridor of the ring, from @p from of its western end [m].
DrivePath alongSouth(const Building& building, double from, double way) {
    const Eigen::Vector2d corner = building.ways.ring.min();
    return DrivePath({{corner.x() + from, corner.y(), 0.0}, {corner.x() + from + way, corner.y(), 0.0}});
}

TEST(DrivePath, RoundsItsCornersAndClimbsRamps) {
    const DrivePath path({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {10, 20, 2}, {10, 30, 2}}, 1.0);
    EXPECT_NEAR(path.length(), 40.0 - 2.0 + 3.14159265 / 2, 1e-6);
    EXPECT_LT(distanceBetween(path.at(0.0), Pose::Identity()), 1e-9);
    double last = 0.0;
    for (double way = 0.01; way <= path.length(); way += 0.01) {
        const Pose a = path.at(way - 0.01), b = path.at(way);
        EXPECT_LT(distanceBetween(a, b), 0.0108) << way;
        EXPECT_LT(angleBetween(a, b), 0.0110) << way;  // no kink: 0.6 degrees in 1 cm at most
        last = b.translation().z();
    }
    EXPECT_NEAR(last, 2.0, 1e-9);
    const Pose slope = path.at(path.length() - 15.0);
    EXPECT_NEAR(inDegrees(std::asin(slope.linear()(2, 0))), inDegrees(std::atan(0.2)), 0.01);
}

TEST(ScriptedDrive, ScansAreWholeTurnsAndLieOnTrueSurfaces) {
    const Building house = building(false);
    ScriptSettings script;
    script.sensor.rangeNoise = 0.0;
    script.odometry = {0.0, 0.0, 0.0, 0.0};
    const ScriptedDrive made = scriptedDrive(house.arena, alongSouth(house, 8.0, 4.0), script);
    ASSERT_GE(made.scans.size(), 12U);
    const NearSurfaces surfaces(house.arena);
    double squares = 0.0;
    std::size_t count = 0;
    for (const LiveScan& live : made.scans) {
        EXPECT_EQ(live.end, TurnEnd::Turn);
        EXPECT_EQ(live.scan->points.size(), 181U * 161U);
        EXPECT_FALSE(live.extrapolated || live.bridged);
        EXPECT_TRUE(live.levelKnown);
        // The robot moved within the turn: only shots cast from where it then was fit together.
        const Pose placed = made.drive.baseInArena(live.scan->end) * live.sensorInBase;
        for (std::size_t i = 0; i < live.scan->points.size(); i += 37) {
            if (!live.scan->points[i].allFinite() || live.scan->points[i].norm() > 6.0F) continue;
            squares += std::pow(surfaces.distance(placed * live.scan->points[i].cast<double>()), 2);
            ++count;
        }
    }
    const double apart = std::sqrt(squares / static_cast<double>(count));
    std::printf("points without noise are %.1f mm from true surfaces\n", 1e3 * apart);
    EXPECT_LT(apart, 0.015);
    EXPECT_NEAR(made.drive.way, 4.0, 1e-9);
}

TEST(ScriptedDrive, IsTheSameWhateverTheNumberOfThreads) {
    const Building house = building(false);
    const auto drive = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return scriptedDrive(house.arena, alongSouth(house, 8.0, 1.0));
    };
    const ScriptedDrive one = drive(1), many = drive(4);
    ASSERT_EQ(one.scans.size(), many.scans.size());
    for (std::size_t i = 0; i < one.scans.size(); ++i) {
        const auto &a = one.scans[i].scan->points, &b = many.scans[i].scan->points;
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t j = 0; j < a.size(); ++j) {
            ASSERT_TRUE(a[j] == b[j] || (!a[j].allFinite() && !b[j].allFinite())) << i << ' ' << j;
        }
        EXPECT_TRUE(one.scans[i].scan->sensorInOdom.matrix() == many.scans[i].scan->sensorInOdom.matrix());
    }
}

/// Largest range and mean of the ranges of what is before the robot's right side, of one scan at rest.
double rangeToTheRight(const ScriptedDrive& made) {
    double sum = 0.0;
    int count = 0;
    for (const Eigen::Vector3f& point : made.scans.front().scan->points) {
        if (!point.allFinite() || std::abs(point.z()) > 0.02F || point.y() > 0.0F) continue;
        if (std::abs(point.x()) > 0.1F) continue;
        sum += static_cast<double>(point.norm());
        ++count;
    }
    return sum / count;
}

TEST(ScriptedDrive, SensorErrorsAreAsTheProfileSays) {
    const Building house = building(true);
    ScriptSettings script;
    const auto drive = [&] { return scriptedDrive(house.arena, alongSouth(house, 20.0, 0.5), script); };
    const double right = rangeToTheRight(drive());
    script.sensor.rangeBias = 0.05;
    EXPECT_NEAR(rangeToTheRight(drive()) - right, 0.05, 0.003);
    script.sensor = {};
    script.sensor.mountShift.y() = 0.1;  // farther from the wall to the right
    EXPECT_NEAR(rangeToTheRight(drive()) - right, 0.1, 0.005);
    script.sensor = worseScanner();
    const ScriptedDrive near = drive();
    for (const Eigen::Vector3f& point : near.scans.front().scan->points)
        EXPECT_FALSE(point.norm() > 8.2F) << point.transpose();
    script.scanSpacing = 0.4;
    script.sensor = {};
    EXPECT_LE(drive().scans.size(), 2U);
}

TEST(BuildingDrive, TwentyMetresOfABareCorridor) {
    const Building house = building(true);
    ScriptSettings script;
    script.sensor.reach = 8.0;
    const Eigen::Vector2d corner = house.ways.ring.min();
    const BuildingRow row =
        driven(house, {{corner.x() + 2.0, corner.y(), 0.0}, {corner.x() + 22.0, corner.y(), 0.0}}, script);
    std::printf(
        "bare corridor: %zu scans, odometry %.3f m, map %.3f m, %d uncertain, %.0f ms a scan, made in %.1f "
        "s\n",
        row.scans, row.odometry, row.entry.ate, row.uncertain, 1e3 * row.median, row.casting);
    EXPECT_GE(row.scans, 55U);
    EXPECT_GT(row.odometry, 0.1);
    EXPECT_EQ(row.uncertain, 0) << "odometry holds the corridor's axis";
    EXPECT_LT(row.entry.ate, 0.8 * row.odometry);
}

TEST(BuildingDrive, TheRingOfASmallBuildingMeetsItself) {
    BuildingSettings settings;
    settings.width = 28.0;
    settings.depth = 20.0;
    settings.troubles = false;
    const Building house = std::move(generateBuilding(settings, 1)).value();
    ScriptSettings script;
    LiveSettings mapping;
    mapping.loops.on = true;
    const auto open = driven(house, ringRoute(house.ways), script);
    const auto closed = driven(house, ringRoute(house.ways), script, mapping);
    std::printf("ring of 28 x 20 m, %zu scans: open %.3f m, seam %.3f m; closed %.3f m, seam %.3f m\n",
                closed.scans, open.final.ate, open.final.seam, closed.final.ate, closed.final.seam);
    EXPECT_EQ(closed.uncertain, 0);
    EXPECT_LT(closed.final.seam, 0.03);
    EXPECT_LT(closed.final.ate, 0.03);
}

}  // namespace
}  // namespace leitstand::simulation::test
