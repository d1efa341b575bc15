#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/mapper.h"
#include "tests/simulation/mapping/building_sets.h"
#include "tests/support/latency.h"

namespace leitstand::simulation::test {
namespace {

/// What `leitstandctl register` comes to on a drive.
struct Registered {
    double ate = 0.0, median = 0.0, longest = 0.0;  ///< [m], a scan [s]
};

Registered registered(const ScriptedDrive& made, const RegistrationSettings& settings) {
    Mapper mapper(settings);
    for (const LiveScan& live : made.scans) mapper.add(live.scan);
    const MapPtr map = mapper.map();
    Trajectory trajectory;
    std::vector<double> seconds;
    for (std::size_t i = 0; i < map->scans.size(); ++i) {
        const LiveScan& live = made.scans[i];
        trajectory.found.push_back(map->scans[i].poseInMap * live.sensorInBase.inverse());
        trajectory.truth.push_back(made.drive.baseInArena(live.scan->end));
        seconds.push_back(map->scans[i].seconds);
    }
    return {errorOf(trajectory).distance, leitstand::test::quantile(seconds, 0.5),
            leitstand::test::quantile(seconds, 1.0)};
}

void expectWithin(const char* how, const ScriptedDrive& made, const RegistrationSettings& settings,
                  double ate) {
    const Registered result = registered(made, settings);
    std::printf("register, %s: %zu scans, %.0f m, ATE %.3f m, %.1f ms a scan (median), %.1f at most\n", how,
                made.scans.size(), made.drive.way, result.ate, 1e3 * result.median, 1e3 * result.longest);
    EXPECT_LE(result.ate, ate) << how;
}

/// Wanted are 0.05 m in a chain and 0.015 m against the map.
TEST(RegisterRingLong, OneAgainstTheOtherAndAgainstTheMap) {
    constexpr std::uint64_t Seed = 101;
    const Building building = std::move(generateBuilding({}, Seed)).value();
    ScriptSettings script;
    script.seed = Seed;
    script.driftBendsTurns = false;
    const ScriptedDrive made = scriptedDrive(building.arena, DrivePath(ringRoute(building.ways)), script);
    RegistrationSettings settings;
    settings.threads = 1;
    expectWithin("chain", made, settings, 0.2);
    settings.reference = Reference::Map;
    expectWithin("map", made, settings, 0.06);
}

}  // namespace
}  // namespace leitstand::simulation::test
