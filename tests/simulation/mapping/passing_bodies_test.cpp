#include "core/mapping/sighting/passing_bodies.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/simulation/mapping/building_sets.h"
#include "tests/simulation/mapping/near_surfaces.h"

namespace leitstand::simulation::test {
namespace {

/// What of a map within 6 m of its scanners is off all that stays, and what is on it.
struct MapPoints {
    std::size_t off = 0, on = 0;
};

MapPoints pointsOf(const LiveMap& map, const NearSurfaces& surfaces, const Pose& mapInArena) {
    constexpr float Near = 6.0F;
    constexpr double Off = 0.25, On = 0.1;  // [m]
    MapPoints found;
    for (const LiveKeyScan& key : map.scans) {
        if (!key.counts()) continue;
        for (const Eigen::Vector3f& point : key.scan->points) {
            if (!(point.norm() < Near)) continue;
            const double distance =
                surfaces.distance(mapInArena * (key.pose.scanInMap * point.cast<double>()));
            if (distance > Off) ++found.off;
            if (distance < On) ++found.on;
        }
    }
    return found;
}

/// Drives a figure of eight through a building in which people walk, with and without looking for them.
void driveAmongPeople(std::uint64_t seed) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    const Building building = std::move(generateBuilding(settings, seed)).value();
    Arena still = building.arena;
    std::erase_if(still.elements,
                  [](const Element& element) { return element.kind == ElementKind::Spectator; });
    const NearSurfaces surfaces(still);
    ScriptSettings script;
    script.seed = seed;
    const ScriptedDrive made = scriptedDrive(building.arena, DrivePath(eightRoute(building.ways, 2)), script);
    LiveMapper mapper("test", {});
    mapper.setBody(made.drive.robot.name, {made.drive.robot.footprint, made.drive.robot.height});
    PassingBodies passing;
    Trajectory trajectory;
    double longest = 0.0, sum = 0.0;
    const LiveMapPtr kept = [&] {
        LiveMapPtr before;
        for (const LiveScan& live : made.scans) {
            const MapUpdate update = mapper.add(live, live.scan->end);
            if (const auto problem = mapper.problem()) (void)mapper.settle(solve(*problem), live.scan->end);
            if (!update.keyScan) continue;
            const double began = processorTime();
            const auto found =
                passing.add(*mapper.map(), update.keyScan->id, mapper.together(update.keyScan->id));
            const double took = processorTime() - began;
            longest = std::max(longest, took);
            sum += took;
            for (const auto& [id, bodies] : found) (void)mapper.leaveOut(id, bodies);
        }
        return mapper.map();
    }();
    for (const LiveKeyScan& key : kept->scans) {
        trajectory.found.push_back(key.pose.scanInMap * key.sensorInBase.inverse());
        trajectory.truth.push_back(made.drive.baseInArena(key.scan->end));
    }
    const TrajectoryError error = errorOf(trajectory);
    const MapPoints after = pointsOf(*kept, surfaces, error.mapInArena);
    LiveMap whole = *kept;
    for (LiveKeyScan& key : whole.scans) {
        if (key.kept) key.scan = key.kept->whole();
    }
    const MapPoints before = pointsOf(whole, surfaces, error.mapInArena);
    std::printf(
        "building %llu: of %zu points off all that stays %zu left, of %zu on it %zu gone; %.1f ms (longest "
        "%.1f) of "
        "a core a key scan; ATE %.3f m\n",
        static_cast<unsigned long long>(seed), before.off, after.off, before.on, before.on - after.on,
        1e3 * sum / static_cast<double>(kept->scans.size()), 1e3 * longest, error.distance);
    EXPECT_LT(static_cast<double>(after.off), 0.25 * static_cast<double>(before.off));
    EXPECT_LT(static_cast<double>(before.on - after.on), 0.002 * static_cast<double>(before.on));
}

TEST(PassingBodiesLong, PeopleWhoWalkLeaveNoGhostsInABuilding) {
    for (const std::uint64_t seed : {measuredSeed(), measuredSeed() + 1}) driveAmongPeople(seed);
}

}  // namespace
}  // namespace leitstand::simulation::test
