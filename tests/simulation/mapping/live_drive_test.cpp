#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include <gtest/gtest.h>

#include "core/mapping/live/scan_doubts.h"
#include "tests/simulation/mapping/mapped_drive.h"
#include "tests/simulation/mapping/uos_registration.h"
#include "tests/support/latency.h"

namespace leitstand::simulation::test {
namespace {

using leitstand::test::quantile;

int uncertain(const MappedDrive& drive) {
    return static_cast<int>(
        std::count_if(drive.localisations.begin(), drive.localisations.end(),
                      [](const Localisation& one) { return one.trust != ScanTrust::Certain; }));
}

void print(const char* how, const TrajectoryError& error, double surfaces) {
    std::printf("  %-41s %5.1f cm (z %4.1f) %5.2f deg (tilt %4.2f) %6.1f cm\n", how, 100.0 * error.distance,
                100.0 * error.height, inDegrees(error.angle), inDegrees(error.tilt), 100.0 * surfaces);
}

constexpr const char* FromUos = "uos scans, guess from odometry alone";

/// What @p drive's scans come to when they are registered again from files.
Trajectory fromUos(const MappedDrive& drive) {
    const UosRegistration again = registeredFromUos(drive);
    std::size_t points = 0;
    for (const LiveScan& scan : drive.scans) points += scan.scan->points.size();
    EXPECT_EQ(again.read, drive.scans.size());
    EXPECT_EQ(again.points, points);
    EXPECT_EQ(again.trajectory.found.size(), drive.scans.size());
    return again.trajectory;
}

LiveSettings previousOnly() {
    LiveSettings settings;
    settings.local.scans = 1;
    settings.match.levelShare = 0.0;
    return settings;
}

LiveSettings refined() {
    LiveSettings settings;
    settings.refinement.on = true;
    return settings;
}

TEST(LiveDrive, AShortDriveIsMappedToTheTruth) {
    const RecordedDrive drive = exploredYellow(4, 45.0);
    const MappedDrive result = mapped(drive, cutScans(drive));
    const TrajectoryError error = errorOf(result.live);
    EXPECT_GT(drive.way, 3.0);
    EXPECT_GE(result.scans.size(), 18U);
    EXPECT_LE(error.distance, 0.05);
    EXPECT_LE(inDegrees(error.angle), 1.0);
    EXPECT_LT(error.distance, errorOf(result.odometry).distance);
    const TrueSurfaces surfaces(drive.arena);
    EXPECT_LE(surfaceError(result, surfaces, false), 0.04);
    EXPECT_EQ(uncertain(result), 0);
    EXPECT_LT(result.map->scans.size(), result.scans.size());
    const Trajectory uos = fromUos(result);
    print("live mapping", error, surfaceError(result, surfaces, false));
    print(FromUos, errorOf(uos), surfaceError(result, surfaces, uos));
    print("odometry alone", errorOf(result.odometry), surfaceError(result, surfaces, true));
    EXPECT_LE(error.distance, errorOf(uos).distance + 0.02);
}

TEST(LiveDriveLong, FiveMinutesInThreeYellowArenas) {
    std::printf("  %-41s %-18s %-23s %s\n", "", "ATE rms", "", "points < 6 m to surfaces");
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const RecordedDrive drive = exploredYellow(seed, 300.0);
        const TrueSurfaces surfaces(drive.arena);
        const auto scans = cutScans(drive);
        const MappedDrive result = mapped(drive, scans);
        const MappedDrive previous = mapped(drive, scans, previousOnly());
        const double seconds =
            std::accumulate(result.localisations.begin(), result.localisations.end(), 0.0,
                            [](double sum, const Localisation& one) { return sum + one.seconds; });
        std::printf(
            "yellow %u: %.1f m, %zu scans, %zu key scans, %d uncertain, %.0f ms a scan, longest %.0f\n",
            static_cast<unsigned>(seed), drive.way, scans.size(), result.map->scans.size(), uncertain(result),
            1e3 * seconds / static_cast<double>(scans.size()), 1e3 * result.longest);
        for (const Localisation& one : result.localisations) {
            if (one.doubts != 0)
                std::printf("  uncertain: %s (overlap %.2f, rms %.3f m, off %.2f m)\n",
                            inWords(one.doubts).c_str(), one.icp.overlap, one.icp.rms,
                            distanceBetween(one.baseInMap, one.guessInMap));
        }
        const TrajectoryError live = errorOf(result.live);
        const double points = surfaceError(result, surfaces, false);
        print("live mapping", live, points);
        print("nearest scan, no level", errorOf(previous.live), surfaceError(previous, surfaces, false));
        const MappedDrive refining = mapped(drive, scans, refined());
        const TrajectoryError refinedError = errorOf(refining.live);
        const double refinedPoints = surfaceError(refining, surfaces, false);
        print("velocity within turns estimated", refinedError, refinedPoints);
        EXPECT_LE(refinedPoints, 0.04) << seed;
        EXPECT_LE(refinedError.distance, 0.08) << seed;
        EXPECT_LE(inDegrees(refinedError.angle), 1.5) << seed;
        const Trajectory uos = fromUos(result);
        print(FromUos, errorOf(uos), surfaceError(result, surfaces, uos));
        print("odometry alone", errorOf(result.odometry), surfaceError(result, surfaces, true));
        EXPECT_LE(live.distance, errorOf(uos).distance + 0.02) << seed;
        EXPECT_LE(live.distance, 0.08) << seed;
        EXPECT_LE(inDegrees(live.angle), 1.5) << seed;
        EXPECT_LE(points, 0.04) << seed;
    }
}

TEST(LiveMappingLatency, ATurnTakesNoMoreTimeInALargeMap) {
    LiveSettings settings;
    settings.keyScans.distance = 0.0;  // every scan enters
    const RecordedDrive drive = exploredYellow(5, 520.0);
    // Processor time: mapping is of one thread, and other programs do not count.
    const double start = processorTime();
    const auto scans = cutScans(drive);
    const double cut = (processorTime() - start) / static_cast<double>(scans.size());
    const MappedDrive result = mapped(drive, scans, settings);
    ASSERT_GE(result.map->scans.size(), 220U);
    ASSERT_EQ(result.busy.size(), result.scans.size());
    std::vector<double> small, large;  // from the 20th, and from the 200th key scan on
    for (std::size_t i = 0; i < result.busy.size(); ++i) {
        const std::uint64_t key = result.localisations[i].keyScan;
        if (key >= 20 && key < 60) small.push_back(result.busy[i]);
        if (key >= 200) large.push_back(result.busy[i]);
    }
    ASSERT_GE(large.size(), 20U);
    std::printf("a turn at 20 to 60 key scans: median %.1f ms\n", 1e3 * quantile(small, 0.5));
    std::printf(
        "at 200 to %zu: shortest %.1f ms, median %.1f ms, 95 of 100 within %.1f ms, longest %.1f ms\n",
        result.map->scans.size(), 1e3 * quantile(large, 0.0), 1e3 * quantile(large, 0.5),
        1e3 * quantile(large, 0.95), 1e3 * quantile(large, 1.0));
    std::printf("cutting it, slice by slice: %.1f ms; by the clock a turn took %.1f ms at most\n", 1e3 * cut,
                1e3 * result.longest);
    EXPECT_LE(quantile(large, 1.0) + cut, 0.15);
    EXPECT_LE(quantile(large, 0.5), 1.5 * quantile(small, 0.5) + 0.005);
}

}  // namespace
}  // namespace leitstand::simulation::test
