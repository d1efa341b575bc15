#include "core/mapping/comparison/map_changes.h"

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/map_problem.h"
#include "tests/simulation/mapping/measured_seed.h"
#include "tests/simulation/mapping/two_days.h"
#include "tests/simulation/mapping/two_drives.h"

namespace leitstand::simulation::test {
namespace {

/// Where an arena's frame lies in a map whose first scan is of @p drive.
Pose arenaIn(const LiveMap& map, const ScriptedDrive& drive) {
    const LiveKeyScan& begin = map.scans.front();
    return begin.pose.scanInMap * begin.sensorInBase.inverse() *
           drive.drive.baseInArena(begin.scan->end).inverse();
}

/// The map of both days, the second put where it is.
LiveMapPtr mapOf(TwoDays& days) {
    rename(days.first, "kurt3d@monday");
    rename(days.second, "kurt3d@tuesday");
    LiveMapper mapper("test", {});
    const RobotDescription& robot = days.first.drive.robot;
    for (const char* name : {"kurt3d@monday", "kurt3d@tuesday"})
        mapper.setBody(name, {robot.footprint, robot.height});
    for (const ScriptedDrive* drive : {&days.first, &days.second}) {
        if (drive == &days.second) {
            const Pose begin = days.baseInArena(*drive->scans.front().scan);
            mapper.place("kurt3d@tuesday", arenaIn(*mapper.map(), days.first) * begin);
        }
        for (const LiveScan& live : drive->scans) {
            (void)mapper.add(live, live.scan->end);
            if (const auto problem = mapper.problem()) (void)mapper.settle(solve(*problem), live.scan->end);
        }
    }
    return mapper.map();
}

TEST(MapChangesLong, WhatCameAndWentBetweenTwoDrivesIsToldAndNothingElse) {
    const int count = measuredBuildings(5);
    int right = 0, missed = 0, wrong = 0;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed(861) + static_cast<std::uint64_t>(i);
        TwoDays days = twoDays(seed);
        const LiveMapPtr map = mapOf(days);
        std::vector<ReportScan> scans;
        for (const LiveKeyScan& scan : map->scans) {
            if (scan.counts()) scans.push_back({scan.id, scan.scan, scan.pose.scanInMap, scan.sensorInBase});
        }
        const auto began = std::chrono::steady_clock::now();
        const MapChanges changes = changesOf(scans);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        EXPECT_EQ(changes.visits.name, "tuesday");
        const ToldChanges reported = judged(changes.things, days, arenaIn(*map, days.first));
        std::printf("changes %llu: %d of %d told, %d wrong, %zu and %zu scans, %.1f s\n",
                    static_cast<unsigned long long>(seed), reported.right, reported.right + reported.missed,
                    reported.wrong, changes.visits.before.size(), changes.visits.after.size(), seconds);
        right += reported.right;
        missed += reported.missed;
        wrong += reported.wrong;
    }
    EXPECT_GE(right, 0.9 * (right + missed));
    EXPECT_LE(wrong, 0.1 * right);
}

}  // namespace
}  // namespace leitstand::simulation::test
