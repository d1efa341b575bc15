#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/offline_mapper.h"
#include "core/mapping/relaxation/closed_map.h"
#include "tests/simulation/mapping/building_sets.h"
#include "tests/support/latency.h"

namespace leitstand::simulation::test {
namespace {

/// What `leitstandctl register` comes to on a drive.
struct Registered {
    double ate = 0.0, mean = 0.0, median = 0.0, longest = 0.0;  ///< [m], a scan [s]
};

/// How far scans at @p poses are off [m].
double errorAt(const std::vector<Pose>& poses, const ScriptedDrive& made) {
    Trajectory trajectory;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const LiveScan& live = made.scans[i];
        trajectory.found.push_back(poses[i] * live.sensorInBase.inverse());
        trajectory.truth.push_back(made.drive.baseInArena(live.scan->end));
    }
    return errorOf(trajectory).distance;
}

MapPtr mapOf(const ScriptedDrive& made, const RegistrationSettings& settings) {
    OfflineMapper mapper(settings);
    for (const LiveScan& live : made.scans) mapper.add(live.scan);
    return mapper.map();
}

Registered registered(const ScriptedDrive& made, const RegistrationSettings& settings) {
    const MapPtr map = mapOf(made, settings);
    std::vector<Pose> poses;
    std::vector<double> seconds;
    for (const MapScan& scan : map->scans) {
        poses.push_back(scan.poseInMap);
        seconds.push_back(scan.seconds);
    }
    const double mean =
        std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(seconds.size());
    return {errorAt(poses, made), mean, leitstand::test::quantile(seconds, 0.5),
            leitstand::test::quantile(seconds, 1.0)};
}

void expectWithin(const char* how, const ScriptedDrive& made, const RegistrationSettings& settings,
                  double ate) {
    const Registered result = registered(made, settings);
    std::printf("register, %s: %zu scans, %.0f m, ATE %.3f m, %.1f ms a scan (median %.1f, %.1f at most)\n",
                how, made.scans.size(), made.drive.way, result.ate, 1e3 * result.mean, 1e3 * result.median,
                1e3 * result.longest);
    EXPECT_LE(result.ate, ate) << how;
    EXPECT_LE(result.mean, 0.02) << how;
}

TEST(RegisterRingLong, OneAgainstTheOtherAndAgainstTheMap) {
    constexpr std::uint64_t Seed = 101;
    const Building building = std::move(generateBuilding({}, Seed)).value();
    ScriptSettings script;
    script.seed = Seed;
    script.driftBendsTurns = false;
    const ScriptedDrive made = scriptedDrive(building.arena, DrivePath(ringRoute(building.ways)), script);
    RegistrationSettings settings;
    settings.threads = 1;
    expectWithin("chain", made, settings, 0.05);
    settings.reference = Reference::Map;
    expectWithin("map", made, settings, 0.015);
    settings.reference = Reference::Previous;
    const MapPtr chain = mapOf(made, settings);
    const auto began = std::chrono::steady_clock::now();
    const auto closed = closeLoops(*chain, {});
    ASSERT_TRUE(closed) << closed.error().text;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    const double ate = errorAt(closed->poses, made);
    std::printf(
        "register, loops closed: %zu closed, %zu unsure, %d rounds, ATE %.3f m, pairs %.1f to %.1f mm, "
        "%.1f s for all\n",
        closed->closed.size(), closed->unsure.size(), closed->relaxation.rounds, ate,
        1e3 * closed->relaxation.rmsBefore, 1e3 * closed->relaxation.rmsAfter, seconds);
    EXPECT_LE(ate, 0.02);
    EXPECT_GE(closed->closed.size(), 1U);
}

TEST(RegisterRingLong, AThousandScansTakeTwentyMillisecondsEachAtMost) {
    constexpr std::uint64_t Seed = 101;
    constexpr double Any = std::numeric_limits<double>::infinity();
    const Building building = std::move(generateBuilding({}, Seed)).value();
    ScriptSettings script;
    script.seed = Seed;
    script.driftBendsTurns = false;
    script.longest = 365.0;
    const ScriptedDrive made = scriptedDrive(building.arena, DrivePath(eightRoute(building.ways, 5)), script);
    ASSERT_GE(made.scans.size(), 1'000U);
    RegistrationSettings settings;
    settings.threads = 1;
    expectWithin("chain", made, settings, Any);
    settings.reference = Reference::Map;
    expectWithin("map", made, settings, Any);
}

}  // namespace
}  // namespace leitstand::simulation::test
