#include <gtest/gtest.h>

#include "tests/simulation/mapping/mapped_drive.h"

namespace leitstand::simulation::test {
namespace {

void tell(const char* what, const TrajectoryError& error) {
    std::printf("  %-10s ATE %.3f m (z %.3f), %.2f deg, tilt %.2f deg\n", what, error.distance, error.height,
                inDegrees(error.angle), inDegrees(error.tilt));
}

TEST(LiveDriveLong, FiveMinutesInThreeYellowArenas) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const RecordedDrive drive = exploredYellow(seed, 300.0);
        const MappedDrive result = mapped(drive, cutScans(drive));
        int uncertain = 0, turns = 0, cut = 0;
        double total = 0.0;
        for (const Localisation& one : result.localisations) {
            total += one.seconds;
            if (one.doubts == 0) continue;
            ++uncertain;
            std::printf("   doubts %d overlap %.2f rms %.3f certainty %.3f\n", one.doubts, one.icp.overlap,
                        one.icp.rms, one.icp.certainty);
        }
        for (const LiveScan& scan : result.scans) (scan.end == TurnEnd::Turn ? turns : cut)++;
        std::printf(
            "seed %u: way %.1f m, %zu scans (%d turns, %d cut), %zu key, %d uncertain, longest %.0f ms, mean "
            "%.0f ms\n",
            static_cast<unsigned>(seed), drive.way, result.scans.size(), turns, cut, result.map->scans.size(),
            uncertain, 1e3 * result.longest, 1e3 * total / static_cast<double>(result.scans.size()));
        tell("live", errorOf(result.live));
        tell("odometry", errorOf(result.odometry));
        EXPECT_LE(errorOf(result.live).distance, 0.08);
        EXPECT_LE(inDegrees(errorOf(result.live).angle), 1.5);
    }
}

}  // namespace
}  // namespace leitstand::simulation::test
