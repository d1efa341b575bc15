#include <algorithm>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "core/event/command_samples.h"
#include "core/event/stream_role.h"
#include "robots/simulation/arena/arena_generator.h"
#include "tests/simulation/drives/seen_floor.h"
#include "tests/simulation/world/operated_robot.h"

namespace leitstand::simulation::test {
namespace {

/// What both robots did together.
struct Together {
    int area = 0, victims = 0, eachOther = 0;    ///< bumps
    double nearest = 99.0;                       ///< their middles [m]
    double kurtSaw = 0.0, crawlerSaw = 0.0;      ///< [m2]
    double reachable = 0.0;                      ///< of the arena's floor [m2]
    double kurtDrove = 0.0, crawlerDrove = 0.0;  ///< [m]
    bool fellOver = false;
};

void letExplore(OperatedRobot& robot) {
    Sender station;
    station.bytes[0] = 1;
    robot.agent().receive(StreamRole::ModeCommand, ModeCommandSample{{}, "station 1", "explore"}, station);
}

/// Kurt3D and the Crawler explore the same yellow arena, side by side at first.
Together exploreTogether(std::uint64_t seed, double seconds) {
    World world(generateArena(Grade::Yellow, seed), seed);
    HardwareSettings fitting;
    fitting.seed = seed;
    fitting.cameras = false;
    OperatedRobot kurt(world, "kurt3d", fitting), crawler(world, "crawler", fitting);
    SeenFloor kurtsFloor(world), crawlersFloor(world, 0.34);
    pass(world, {&kurt, &crawler}, 0.5);
    letExplore(kurt);
    letExplore(crawler);
    Together result;
    const auto placeOf = [](const OperatedRobot& robot) {
        return Eigen::Vector2d(robot.state().baseInArena.translation().head<2>());
    };
    Eigen::Vector2d kurtWas = placeOf(kurt), crawlerWas = placeOf(crawler);
    for (double passed = 0.0; passed < seconds; passed += 0.1) {
        pass(world, {&kurt, &crawler}, 0.1);
        kurtsFloor.look(kurt.number());
        crawlersFloor.look(crawler.number());
        result.nearest = std::min(result.nearest, (placeOf(kurt) - placeOf(crawler)).norm());
        result.kurtDrove += (placeOf(kurt) - kurtWas).norm();
        result.crawlerDrove += (placeOf(crawler) - crawlerWas).norm();
        kurtWas = placeOf(kurt);
        crawlerWas = placeOf(crawler);
        kurt.forget();
        crawler.forget();
    }
    for (const Bump& bump : world.bumps()) {
        const bool robot = bump.element == "kurt3d" || bump.element == "crawler";
        ++(robot ? result.eachOther : bump.victim ? result.victims : result.area);
    }
    result.fellOver = kurt.state().tipped || crawler.state().tipped;
    result.kurtSaw = kurtsFloor.area();
    result.crawlerSaw = crawlersFloor.area();
    result.reachable = kurtsFloor.reachable().area();
    std::printf(
        "yellow %u, %.0f s: Kurt3D drove %.1f m and saw %.1f m2, the Crawler %.1f m and %.1f m2 of "
        "%.1f; middles %.2f m apart at the least; bumps: %d area, %d victims, %d each other\n",
        static_cast<unsigned>(seed), seconds, result.kurtDrove, result.kurtSaw, result.crawlerDrove,
        result.crawlerSaw, kurtsFloor.reachable().area(), result.nearest, result.area, result.victims,
        result.eachOther);
    return result;
}

TEST(BothExplore, AMinuteWithoutRunningIntoOneAnother) {
    const Together result = exploreTogether(7, 60.0);
    EXPECT_EQ(result.eachOther, 0);
    EXPECT_LE(result.area + result.victims, 2);
    EXPECT_FALSE(result.fellOver);
    EXPECT_GT(result.kurtDrove, 2.0);
    EXPECT_GT(result.crawlerDrove, 2.0);
}

/// Five minutes in the yellow arena of a seed.
class BothExploreLong : public testing::TestWithParam<std::uint64_t> {};

TEST_P(BothExploreLong, FiveMinutesInWhichNeitherWaitsForTheOtherForGood) {
    const Together result = exploreTogether(GetParam(), 300.0);
    EXPECT_FALSE(result.fellOver);
    EXPECT_LE(result.area + result.victims, 10);
    EXPECT_LE(result.eachOther, 2);
    EXPECT_GT(result.kurtDrove, 15.0);
    EXPECT_GT(result.crawlerDrove, 15.0);
    EXPECT_GT(result.kurtSaw, 0.5 * result.reachable);
    EXPECT_GT(result.crawlerSaw, 0.5 * result.reachable);
}

INSTANTIATE_TEST_SUITE_P(Yellow, BothExploreLong, testing::Range<std::uint64_t>(1, 9));

}  // namespace
}  // namespace leitstand::simulation::test
