#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/mapping/live/scan_work.h"
#include "tests/core/mapping/live/mapped_room.h"
#include "tests/core/mapping/live/page_memory.h"

namespace leitstand::test {
namespace {

/// What a key scan may take: its points, labels and shades, and what is matched of it with normals,
/// packed.
std::size_t mostOf(const LiveKeyScan& scan) {
    constexpr std::size_t Point = 12 + 1 + 1, Matched = 6 + 6, Rest = 1'024;
    return Point * scan.scan->points.size() + Matched * scan.reduced->size().value() + Rest;
}

LiveScan withIntensities(LiveScan live) {
    auto scan = std::make_shared<Scan>(*live.scan);
    scan->intensities.assign(scan->points.size(), 0.5F);
    live.scan = std::move(scan);
    return live;
}

TEST(MapMemory, AKeyScanTakesNoMoreThanItsPoints) {
    MappedRoom room;
    for (unsigned i = 0; i < 4; ++i) {
        const Pose sensor = poseFrom({-1.4 + 0.4 * i, 0.0, 0.9}, 0, 0, 0);
        const MapUpdate update = room.add(withIntensities(scanAt(sensor, i + 1)));
        ASSERT_TRUE(update.keyScan);
        EXPECT_EQ(update.keyScan->scan->intensities.size(), update.keyScan->scan->points.size())
            << "the log has all that was measured";
    }
    const LiveMapPtr map = room.mapper.map();
    for (const LiveKeyScan& scan : map->scans) {
        EXPECT_GT(scan.scan->points.size(), 5'000U);
        EXPECT_LE(memoryOf(scan), mostOf(scan)) << scan.id;
        std::printf("[          ] %zu points, %zu matched: %.1f kB\n", scan.scan->points.size(),
                    scan.reduced->size().value(), 1e-3 * static_cast<double>(memoryOf(scan)));
    }
}

TEST(MapMemory, NorDoesOneThatIsTakenBackFromTheLog) {
    MappedRoom room;
    ASSERT_TRUE(room.add(withIntensities(scanAt(poseFrom({-1.4, 0.0, 0.9}, 0, 0, 0), 1))).keyScan);
    const LiveMapper again = room.log.readAgain();
    const LiveMapPtr map = again.map();
    ASSERT_EQ(map->scans.size(), 1U);
    (void)map->scans.front().reduced->unpacked();  // as it does once a robot is there
    EXPECT_LE(memoryOf(map->scans.front()), mostOf(map->scans.front()));
}

TEST(MapMemory, NorDoesOneInWhichAnotherRobotStood) {
    MappedRoom room;
    ASSERT_TRUE(room.add(withIntensities(scanAt(poseFrom({-1.4, 0.0, 0.9}, 0, 0, 0), 1))).keyScan);
    const std::weak_ptr<const Scan> whole = room.mapper.map()->scans.front().scan;
    const Eigen::Vector3d wall = whole.lock()->points.front().cast<double>();
    const Pose there = poseFrom(wall - Eigen::Vector3d(0, 0, 1.0), 0, 0, 0);
    ASSERT_TRUE(room.mapper.leaveOut(
        1, {{"crawler", {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, 3.0, there, PlacedBody::Certain}}));
    EXPECT_TRUE(whole.expired()) << "all its points are kept beside those that are left";
}

TEST(MapMemory, OfScansFarFromEveryRobotOnlyThePointsAreLeft) {
    MappedRoom room;
    LiveSettings settings;
    const auto store = std::make_shared<PageMemory>();
    settings.pages = store;
    room.mapper = LiveMapper("station", settings);
    constexpr unsigned Scans = 200;
    for (unsigned i = 0; i < Scans; ++i) {  // there and back again, with a scan each 10 degrees or 0.3 m
        const double along = 1.6 * std::sin(0.4 * i);
        const LiveScan scan =
            scanAt(poseFrom({along, 0.3 * std::cos(0.7 * i), 0.9}, 0, 0, degrees(11.0 * i)), i + 1);
        (void)room.add(withIntensities(scan));
    }
    const LiveMapPtr map = room.mapper.map();
    ASSERT_GT(map->scans.size(), 150U);
    std::size_t bytes = 0, points = 0, matched = 0;
    for (const LiveKeyScan& scan : map->scans) {
        bytes += memoryOf(scan);
        points += scan.scan->points.size();
        matched += scan.reduced->memory();
    }
    const auto scans = static_cast<double>(map->scans.size());
    std::printf("[          ] %.0f key scans of %.0f points: %.1f kB each, %.1f kB of them what is matched\n",
                scans, static_cast<double>(points) / scans, 1e-3 * static_cast<double>(bytes) / scans,
                1e-3 * static_cast<double>(matched) / scans);
    EXPECT_LE(bytes, 14 * points + matched + 1'024 * map->scans.size());
    const auto inMemory = std::count_if(map->scans.begin(), map->scans.end(),
                                        [](const LiveKeyScan& scan) { return scan.reduced->memory() > 0; });
    EXPECT_LE(static_cast<std::size_t>(inMemory), MatchedClouds::Usual);
    EXPECT_GE(store->pages.size(), map->scans.size() - MatchedClouds::Usual);
}

TEST(MapMemory, SnapshotsShareThePoints) {
    MappedRoom room;
    room.drive(2);
    const LiveMapPtr first = room.mapper.map(), second = room.mapper.map();
    for (std::size_t i = 0; i < first->scans.size(); ++i) {
        EXPECT_EQ(first->scans[i].scan, second->scans[i].scan);
        EXPECT_EQ(first->scans[i].reduced, second->scans[i].reduced);
    }
}

}  // namespace
}  // namespace leitstand::test
