#include "tests/app/latency/grown_map.h"

#include <utility>

#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "core/event/map_samples.h"
#include "core/event/station_topics.h"

namespace leitstand::test {

void growMap(const std::filesystem::path& folder, const std::vector<RobotDescription>& robots,
             const LiveMap& map, std::size_t count) {
    ASSERT_FALSE(map.scans.empty()) << "nothing to grow from";
    LiveMissionSettings settings;
    settings.folder = folder;
    settings.robots = robots;
    settings.version = "test";
    auto opened = LiveMission::open(settings);
    ASSERT_TRUE(opened.ok()) << opened.error().text;
    const auto mission = std::move(opened).value();
    std::uint64_t newest = map.scans.back().id;
    for (std::size_t i = map.scans.size(); i < count; ++i) {
        const LiveKeyScan& one = map.scans[i % map.scans.size()];
        KeyScanSample copy;
        copy.stamp = stationTime();
        copy.scan = one.scan;
        copy.sensorInBase = one.sensorInBase;
        copy.scanInMap = one.pose.scanInMap;
        copy.matched = newest;
        copy.id = ++newest;
        const auto reported = mission->record(copy, station_topic::KeyScans);
        ASSERT_TRUE(reported.ok()) << reported.error().text;
    }
    const auto closed = mission->close();
    ASSERT_TRUE(closed.ok()) << closed.error().text;
}

}  // namespace leitstand::test
