#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "tests/simulation/mapping/building_sets.h"
#include "tests/simulation/mapping/loop_score.h"
#include "tests/simulation/mapping/measured_seed.h"

namespace leitstand::simulation::test {
namespace {

/// The loops of a drive of some 200 m through a building of 30 x 20 m.
LoopScore scoreIn(const BuildingSettings& settings, const OdometryErrors& odometry, std::uint64_t seed) {
    const Building building = std::move(generateBuilding(settings, seed)).value();
    ScriptSettings script;
    script.seed = seed;
    script.odometry = odometry;
    LiveSettings mapping;
    mapping.loops.on = true;
    ScriptedDrive made = scriptedDrive(building.arena, DrivePath(eightRoute(building.ways, 4)), script);
    return loopScore(mapped(made.drive, std::move(made.scans), mapping), made.drive);
}

void print(const std::string& name, const LoopScore& score) {
    std::printf("%s: %d links, %d wrong, %d asked, %d of those wrong, %d of %d revisits closed\n",
                name.c_str(), score.links, score.wrong, score.asked, score.misled, score.closed,
                score.revisits);
}

LoopScore total(const char* name, const BuildingSettings& settings, const OdometryErrors& odometry,
                std::uint64_t first) {
    LoopScore sum;
    for (int i = 0; i < measuredBuildings(20); ++i) {
        const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
        const LoopScore one = scoreIn(settings, odometry, seed);
        print(name + std::string(" ") + std::to_string(seed), one);
        sum.links += one.links;
        sum.wrong += one.wrong;
        sum.asked += one.asked;
        sum.misled += one.misled;
        sum.revisits += one.revisits;
        sum.closed += one.closed;
    }
    print(name, sum);
    return sum;
}

TEST(BuildingLoopsLong, NoneIsWrongWhereRoomsAndCorridorsAreAlike) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    settings.twins = true;
    settings.troubles = false;
    const LoopScore score = total("twins", settings, {}, 201);
    EXPECT_EQ(score.wrong, 0);
    EXPECT_EQ(score.misled, 0);
    EXPECT_GT(score.links, 0);
}

TEST(BuildingLoopsLong, RevisitsAreClosedWithOdometryThatErrsByATenth) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    settings.troubles = false;
    OdometryErrors odometry;
    odometry.scale = 0.1;
    odometry.headingBias = degrees(0.16);
    const LoopScore score = total("drift", settings, odometry, 301);
    EXPECT_EQ(score.wrong, 0);
    EXPECT_EQ(score.misled, 0);
    EXPECT_GE(score.closed, 0.95 * score.revisits);
}

}  // namespace
}  // namespace leitstand::simulation::test
