#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>

#include <gtest/gtest.h>

#include "core/mapping/live/scan_doubts.h"
#include "tests/simulation/mapping/mapped_drive.h"

namespace leitstand::simulation::test {
namespace {

int uncertain(const MappedDrive& drive) {
    return static_cast<int>(
        std::count_if(drive.localisations.begin(), drive.localisations.end(),
                      [](const Localisation& one) { return one.trust != ScanTrust::Certain; }));
}

void tell(const char* how, const TrajectoryError& error, double surfaces) {
    std::printf("  %-22s %5.1f cm (z %4.1f) %5.2f deg (tilt %4.2f) %6.1f cm\n", how, 100.0 * error.distance,
                100.0 * error.height, inDegrees(error.angle), inDegrees(error.tilt), 100.0 * surfaces);
}

LiveSettings previousOnly() {
    LiveSettings settings;
    settings.local.scans = 1;
    settings.match.levelShare = 0.0;
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
    EXPECT_LE(surfaceError(result, TrueSurfaces(drive.arena), false), 0.04);
    EXPECT_EQ(uncertain(result), 0);
    EXPECT_LT(result.map->scans.size(), result.scans.size());
}

TEST(LiveDriveLong, FiveMinutesInThreeYellowArenas) {
    std::printf("  %-22s %-18s %-23s %s\n", "", "ATE rms", "", "points < 6 m to surfaces");
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
        tell("live mapping", live, points);
        tell("nearest scan, no level", errorOf(previous.live), surfaceError(previous, surfaces, false));
        tell("odometry alone", errorOf(result.odometry), surfaceError(result, surfaces, true));
        EXPECT_LE(live.distance, 0.08) << seed;
        EXPECT_LE(inDegrees(live.angle), 1.5) << seed;
        EXPECT_LE(points, 0.04) << seed;
    }
}

TEST(LiveMappingLatency, ATurnTakesNoMoreTimeInALargeMap) {
    LiveSettings settings;
    settings.keyScans.distance = 0.0;  // every scan enters
    const RecordedDrive drive = exploredYellow(5, 520.0);
    const auto start = std::chrono::steady_clock::now();
    const auto scans = cutScans(drive);
    const std::chrono::duration<double> cutting = std::chrono::steady_clock::now() - start;
    const MappedDrive result = mapped(drive, scans, settings);
    ASSERT_GE(result.map->scans.size(), 220U);
    // A quarter of the scans is quicker: what else the computer does counts little.
    const auto quick = [&](std::size_t from, std::size_t to) {
        std::vector<double> times;
        for (std::size_t i = from; i < to; ++i) times.push_back(result.localisations[i].seconds);
        std::sort(times.begin(), times.end());
        return times[times.size() / 4];
    };
    const double small = quick(20, 60), large = quick(result.scans.size() - 40, result.scans.size());
    std::printf("a turn: %.1f ms at 20 to 60 key scans, %.1f ms at %zu, longest %.1f ms\n", 1e3 * small,
                1e3 * large, result.map->scans.size(), 1e3 * result.longest);
    const double cut = cutting.count() / static_cast<double>(scans.size());
    std::printf("cutting it, slice by slice: %.1f ms\n", 1e3 * cut);
    EXPECT_LE(large + cut, 0.15);
    EXPECT_LE(large, 2.0 * small + 0.01);
}

}  // namespace
}  // namespace leitstand::simulation::test
