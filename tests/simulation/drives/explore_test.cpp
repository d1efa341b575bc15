#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_generator.h"
#include "tests/simulation/drives/exploration.h"

namespace leitstand::simulation::test {
namespace {

Exploration exploreYellow(std::uint64_t seed, double seconds, const DriveSetup& like = {}) {
    DriveSetup setup = like;
    setup.seed = seed;
    DrivenWorld driven(generateArena(Grade::Yellow, seed), setup);
    SeenFloor floor(*driven.world);
    Exploration result = explore(driven, floor, seconds);
    std::printf("yellow %llu: %4.0f s, %5.1f %% of %.1f m2 seen, %d bumps, %d of %zu victims, %d false%s%s\n",
                static_cast<unsigned long long>(seed), result.seconds, 100.0 * result.seen,
                floor.reachable().area(), result.bumps, result.found(), result.victims.size(),
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

TEST(ExploreLong, TenMinutesInYellowArenas) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Exploration result = exploreYellow(seed, 600.0);
        EXPECT_GE(result.seen, 0.7) << seed;
        EXPECT_LE(result.bumps, 2) << seed;
        EXPECT_GE(2 * result.found(), static_cast<int>(result.victims.size())) << seed;
    }
}

}  // namespace
}  // namespace leitstand::simulation::test
