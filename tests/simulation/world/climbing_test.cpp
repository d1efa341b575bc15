#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/arena/building_generator.h"
#include "tests/simulation/world/operated_robot.h"
#include "tests/simulation/world/test_arena.h"

namespace leitstand::simulation {
namespace {

/// How a robot got on that was driven straight ahead.
struct Climb {
    double way = 0.0;       ///< farthest ahead of where it began [m]
    double height = 0.0;    ///< of base_link at the end [m]
    double steepest = 0.0;  ///< nose up [rad]
    bool tipped = false;
    std::string met;  ///< what it bumped into first
};

/// Drives the robot of @p kind in @p arena from @p start for @p length, or until @p seconds are over.
Climb climb(const Arena& arena, const std::string& kind, const Pose& start, double length, double seconds) {
    World world(arena, arena.seed);
    OperatedRobot robot(world, kind, start);
    const double heading = std::atan2(start.linear()(1, 0), start.linear()(0, 0));
    Climb climb;
    double got = 0.0;
    while (world.seconds() < seconds && climb.way < length && !climb.tipped) {
        pass(world, {&robot}, 0.05, [&](OperatedRobot& one) {
            one.wishHeading(0.25, heading);
            climb.steepest = std::max(climb.steepest, -pitchOf(one.state()));
        });
        const double way = (start.inverse() * robot.state().baseInArena.translation()).x();
        if (way > climb.way + 0.01) got = world.seconds();
        if (world.seconds() - got > 4.0) break;  // stuck
        climb.way = std::max(climb.way, way);
        climb.tipped = robot.state().tipped;
    }
    climb.height = robot.state().baseInArena.translation().z();
    if (!world.bumps().empty()) climb.met = world.bumps().front().element;
    return climb;
}

TEST(Climbing, TheCrawlerGetsUpTheStairsOfOrangeArenasAndKurt3dDoesNot) {
    int climbed = 0;
    double lowest = 1.0, highest = 0.0;
    for (const std::uint64_t seed : {1, 2, 4, 8, 10}) {
        const Arena arena = generateArena(Grade::Orange, seed);
        for (const Element& stairs : arena.elements) {
            if (stairs.kind != ElementKind::Stairs) continue;
            const double before = stairs.size.x() / 2 + 0.35;
            const Pose start = stairs.pose * poseFrom({-before, 0, 0}, 0, 0, 0);
            const Climb crawler = climb(arena, "crawler", start, stairs.size.x() + 0.60, 14.0);
            EXPECT_NEAR(crawler.height, stairs.size.z(), 0.005) << arena.name;
            EXPECT_FALSE(crawler.tipped) << arena.name;
            EXPECT_EQ(crawler.met, "") << arena.name;
            const Climb kurt3d = climb(arena, "kurt3d", start, stairs.size.x() + 0.60, 14.0);
            EXPECT_LT(kurt3d.height, 0.01) << arena.name;
            EXPECT_EQ(kurt3d.met, stairs.name) << arena.name;
            std::printf("%s: risers of %.1f cm, the Crawler %.2f m up at %.0f degrees, Kurt3D stopped\n",
                        arena.name.c_str(), 100 * stairs.riser, crawler.height, inDegrees(crawler.steepest));
            lowest = std::min(lowest, stairs.riser);
            highest = std::max(highest, stairs.riser);
            ++climbed;
        }
    }
    EXPECT_EQ(climbed, 5);
    EXPECT_NEAR(lowest, 0.08, 1e-9) << "the easiest and ...";
    EXPECT_NEAR(highest, 0.10, 1e-9) << "... the hardest that the generator makes";
}

TEST(Climbing, Kurt3dGetsUpTheRampOfABuildingAndTheCrawlerUpItsStairs) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    settings.storeys = 2;
    const Building building = std::move(generateBuilding(settings, 3)).value();
    const Eigen::Vector3d from = building.ways.ramps.at(0).at(1), top = building.ways.ramps.at(0).at(4);
    const Eigen::Vector3d along = top - from;
    const Pose start = poseFrom(from, 0.0, 0.0, std::atan2(along.y(), along.x()));
    const double length = along.head<2>().norm();
    const Climb kurt3d = climb(building.arena, "kurt3d", start, length - 0.1, 90.0);
    EXPECT_NEAR(kurt3d.height, top.z(), 0.005);
    EXPECT_EQ(kurt3d.met, "");
    EXPECT_LT(inDegrees(kurt3d.steepest), 12.5);
    const auto stairs = std::find_if(building.arena.elements.begin(), building.arena.elements.end(),
                                     [](const Element& one) { return one.kind == ElementKind::Stairs; });
    ASSERT_NE(stairs, building.arena.elements.end());
    const double before = stairs->size.x() / 2 + 0.35;
    const Pose below = stairs->pose * poseFrom({-before, 0, 0}, 0, 0, 0);
    const Climb crawler = climb(building.arena, "crawler", below, stairs->size.x() + 0.6, 60.0);
    EXPECT_NEAR(crawler.height, top.z(), 0.005);
    EXPECT_FALSE(crawler.tipped);
}

/// Whether nothing but the ground is ahead of @p start for @p length, as wide as both robots are.
bool isFree(const Arena& arena, const Pose& start, double length) {
    const Scene scene(arena);
    for (const double y : {-0.25, 0.0, 0.25}) {
        for (const double z : {0.26, 0.4, 0.55}) {
            Ray ray;
            ray.origin = (start * Eigen::Vector3d(-0.25, y, z)).cast<float>();
            ray.direction = start.linear().col(0).cast<float>();
            ray.far = static_cast<float>(length + 0.25);
            if (scene.cast(ray, RayKind::Contact).there()) return false;
            // ... and it begins on the level.
            ray.origin = (start * Eigen::Vector3d(0.0, y, 0.5)).cast<float>();
            ray.direction = -Eigen::Vector3f::UnitZ();
            ray.far = 0.49F;
            if (scene.cast(ray, RayKind::Contact).there()) return false;
        }
    }
    return true;
}

/// How many of the ways over step fields of red arenas the robots get across.
struct Crossings {
    int tried = 0, crawler = 0, kurt3d = 0;
};

/// Of the arenas of seeds @p first to @p last: from all four sides where nothing else is in the way.
Crossings crossings(std::uint64_t first, std::uint64_t last) {
    Crossings crossings;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        const Arena arena = generateArena(Grade::Red, seed);
        for (const Element& field : arena.elements) {
            if (field.kind != ElementKind::StepField) continue;
            for (const double from : {0.0, 90.0, 180.0, 270.0}) {
                const Pose start =
                    field.pose * poseFrom({0, 0, 0}, 0, 0, degrees(from)) * poseFrom({-0.85, 0, 0}, 0, 0, 0);
                const double across = 0.85 + 0.6 + 0.25;  // to where all of it is behind the field
                if (!isFree(arena, start, across + 0.3)) continue;
                ++crossings.tried;
                const Climb crawler = climb(arena, "crawler", start, across, 20.0);
                crossings.crawler += crawler.way >= across && !crawler.tipped ? 1 : 0;
                const Climb kurt3d = climb(arena, "kurt3d", start, across, 20.0);
                crossings.kurt3d += kurt3d.way >= across && !kurt3d.tipped ? 1 : 0;
            }
        }
    }
    std::printf("of %d ways over step fields, the Crawler crosses %d, Kurt3D %d\n", crossings.tried,
                crossings.crawler, crossings.kurt3d);
    return crossings;
}

TEST(Climbing, TheCrawlerCrossesTheStepFieldsOfARedArenaAndKurt3dDoesNot) {
    const Crossings red = crossings(2, 2);
    EXPECT_GE(red.tried, 8);
    EXPECT_GE(red.crawler, red.tried * 9 / 10);
    EXPECT_EQ(red.kurt3d, 0);
}

TEST(ClimbingLong, TheCrawlerCrossesTheStepFieldsOfMostRedArenas) {
    const Crossings red = crossings(1, 12);
    EXPECT_GE(red.crawler, red.tried * 9 / 10);
    EXPECT_EQ(red.kurt3d, 0);
}

}  // namespace
}  // namespace leitstand::simulation
