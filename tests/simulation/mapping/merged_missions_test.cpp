#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/handin/report_source.h"
#include "app/services/log/live_mission.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/merged_map.h"
#include "app/services/review/map_tidying.h"
#include "core/event/scan_bodies.h"
#include "core/event/station_topics.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/sighting/passing_bodies.h"
#include "tests/simulation/mapping/measured_seed.h"
#include "tests/simulation/mapping/trajectory.h"
#include "tests/simulation/mapping/two_days.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::simulation::test {
namespace {

using leitstand::test::TemporaryFolder;

template <class Said>
void publish(LiveMission& mission, const std::optional<Said>& reported, std::string_view topic) {
    if (!reported) return;
    const auto done = mission.record(*reported, topic);
    EXPECT_TRUE(done) << done.error().text;
}

/// Leaves out of @p mapper's map who @p passing finds to have passed by, now that the scan @p id is in it.
void leaveOutPassing(LiveMapper& mapper, PassingBodies& passing, std::uint64_t id, Time now,
                     LiveMission& mission) {
    auto found = passing.add(*mapper.map(), id, mapper.together(id));
    std::erase_if(found, [&](const auto& bodies) { return !mapper.leaveOut(bodies.first, bodies.second); });
    for (const ScanBodiesSample& sample : inSamples(std::move(found), now)) {
        const auto done = mission.record(sample, station_topic::ScanBodies);
        EXPECT_TRUE(done) << done.error().text;
    }
}

/// The mission that a station records which maps @p drive.
void record(const std::filesystem::path& folder, const ScriptedDrive& drive) {
    LiveMissionSettings settings;
    settings.folder = folder;
    settings.robots = {drive.drive.robot};
    settings.station = "test";
    auto opened = LiveMission::open(settings);
    ASSERT_TRUE(opened) << opened.error().text;
    LiveMission& mission = **opened;
    LiveMapper mapper("test", {});
    mapper.setBody("kurt3d", {drive.drive.robot.footprint, drive.drive.robot.height});
    PassingBodies passing;
    for (const LiveScan& live : drive.scans) {
        const Time now = live.scan->end;
        const MapUpdate update = mapper.add(live, now);
        publish(mission, update.keyScan, station_topic::KeyScans);
        publish(mission, update.links, station_topic::ScanLinks);
        publish(mission, update.poses, station_topic::ScanPoses);
        publish(mission, update.loop, station_topic::ScanLinks);
        if (const auto problem = mapper.problem()) {
            const Settled settled = mapper.settle(solve(*problem), now);
            publish(mission, settled.poses, station_topic::ScanPoses);
        }
        if (update.keyScan) leaveOutPassing(mapper, passing, update.keyScan->id, now, mission);
    }
    ASSERT_TRUE(mission.close());
}

/// How far the map of @p scans is from the truth of @p days.
Trajectory trajectoryOf(const std::vector<ReportScan>& scans, const TwoDays& days) {
    Trajectory trajectory;
    for (const ReportScan& scan : scans) {
        trajectory.found.push_back(scan.baseInMap());
        trajectory.truth.push_back(days.baseInArena(*scan.scan));
    }
    return trajectory;
}

TEST(MergedMissionsLong, TwoDaysInABuildingAreOneMapThatTellsWhatChanged) {
    const int count = measuredBuildings(3);
    int right = 0, missed = 0, wrong = 0;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed(871) + static_cast<std::uint64_t>(i);
        const TwoDays days = twoDays(seed);
        const TemporaryFolder temporary;
        // LEITSTAND_KEEP=FOLDER leaves the missions there, for people to look at.
        const char* const kept = std::getenv("LEITSTAND_KEEP");
        const std::filesystem::path folder = kept != nullptr ? std::filesystem::path(kept) : temporary / "";
        MergeOrder order;
        order.first = folder / "monday";
        order.second = folder / "tuesday";
        order.into = folder / "both";
        ASSERT_NO_FATAL_FAILURE(record(order.first, days.first));
        ASSERT_NO_FATAL_FAILURE(record(order.second, days.second));
        const auto merged = mergeMaps(order);
        ASSERT_TRUE(merged) << merged.error().text;
        ASSERT_TRUE(merged->together) << "seed " << seed;
        const auto untidied = ReportSource::open(order.into);
        ASSERT_TRUE(untidied);
        const Trajectory joined = trajectoryOf(untidied->input().scans, days);
        ASSERT_TRUE(tidyMap(order.into));
        const auto source = ReportSource::open(order.into);
        ASSERT_TRUE(source);
        const std::vector<ReportScan>& scans = source->input().scans;
        const Trajectory tidied = trajectoryOf(scans, days);
        const MapChanges changes = changesOf(scans);
        const Pose arenaInMap = scans.front().baseInMap() * days.baseInArena(*scans.front().scan).inverse();
        const ToldChanges reported = judged(changes.things, days, arenaInMap);
        std::printf(
            "merged %llu: %zu of %zu places agree, ATE %.3f m, seam %.3f m; tidied %.3f and %.3f m; changes "
            "%d of %d told, %d wrong\n",
            static_cast<unsigned long long>(seed), merged->agreeing, merged->sought, errorOf(joined).distance,
            worstSeam(joined), errorOf(tidied).distance, worstSeam(tidied), reported.right,
            reported.right + reported.missed, reported.wrong);
        EXPECT_LT(errorOf(tidied).distance, 0.05);
        EXPECT_LT(worstSeam(tidied), 0.08);
        right += reported.right;
        missed += reported.missed;
        wrong += reported.wrong;
    }
    EXPECT_GE(right, 0.9 * (right + missed));
    EXPECT_LE(wrong, 0.1 * right);
}

}  // namespace
}  // namespace leitstand::simulation::test
