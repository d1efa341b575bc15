#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_generator.h"
#include "tests/simulation/drives/exploration.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Scanner = 0.48;      ///< of Kurt3D, over its ground [m]
constexpr double CrawlersEye = 0.34;  ///< mirror of its camera [m]

Exploration exploreYellow(std::uint64_t seed, double seconds, const DriveSetup& like = {}) {
    DriveSetup setup = like;
    setup.seed = seed;
    DrivenWorld driven(generateArena(Grade::Yellow, seed), setup);
    SeenFloor floor(*driven.world, setup.kind == "crawler" ? CrawlersEye : Scanner);
    double steepest = 0.0;
    Exploration result = explore(driven, floor, seconds, [&] {
        steepest = std::max(steepest, std::acos(std::min(1.0, driven.state().baseInArena.linear()(2, 2))));
    });
    EXPECT_FALSE(driven.state().tipped) << seed;
    std::printf(
        "%s in yellow %llu: %4.0f s, %5.1f %% of %.1f m2 seen, leant %.0f degrees, %d bumps, "
        "%d of %zu victims, %d false%s%s\n",
        setup.kind.c_str(), static_cast<unsigned long long>(seed), result.seconds, 100.0 * result.seen,
        floor.reachable().area(), inDegrees(steepest), result.bumps, result.found(), result.victims.size(),
        result.falseReports, result.ended.empty() ? "" : ": ", result.ended.c_str());
    return result;
}

TEST(Explore, TwoMinutesShowMuchOfTheFloorWithoutABump) {
    DriveSetup setup;
    setup.infrared = false;  // victims would hold it up, and cost most of the time
    const Exploration result = exploreYellow(1, 120.0, setup);
    EXPECT_GE(result.seen, 0.6);
    EXPECT_LE(result.bumps, 1);
}

TEST(Explore, AMinuteOfTheCrawler) {
    DriveSetup setup;
    setup.kind = "crawler";
    const Exploration result = exploreYellow(7, 60.0, setup);
    EXPECT_GE(result.seen, 0.35);
    EXPECT_LE(result.bumps, 1);
    EXPECT_EQ(result.ended, "");
}

TEST(ExploreLong, TenMinutesInYellowArenas) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Exploration result = exploreYellow(seed, 600.0);
        EXPECT_GE(result.seen, 0.7) << seed;
        EXPECT_LE(result.bumps, 2) << seed;
        EXPECT_GE(2 * result.found(), static_cast<int>(result.victims.size())) << seed;
        EXPECT_LE(result.falseReports, 1) << seed;
    }
}

TEST(ExploreLong, TenMinutesOfTheCrawlerInYellowArenas) {
    DriveSetup setup;
    setup.kind = "crawler";
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U}) {
        const Exploration result = exploreYellow(seed, 600.0, setup);
        EXPECT_GE(result.seen, 0.6) << seed;
        EXPECT_LE(result.bumps, 6) << seed;
    }
}

}  // namespace
}  // namespace leitstand::simulation::test
