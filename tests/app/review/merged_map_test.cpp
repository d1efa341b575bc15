#include "app/services/recorded/merged_map.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/report_source.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/carried_map.h"
#include "app/services/recorded/recorded_map.h"
#include "app/services/review/playing/review_player.h"
#include "core/event/station_topics.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/review/written_room.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::Le;

/// Places on the way back through the room, more to its right.
std::vector<Pose> backThroughTheRoom() {
    std::vector<Pose> places;
    for (int i = 0; i < 6; ++i)
        places.push_back(poseFrom({1.2 - 0.4 * i, -0.3 - 0.05 * i, 0.9}, 0, 0, degrees(170 + 4 * i)));
    return places;
}

/// What two robots said on two days that were in the same room, from other places.
class MergedMaps : public testing::Test {
protected:
    MergedMaps() {
        order.first = write("monday", alongTheRoom());
        order.second = write("tuesday", backThroughTheRoom(), 1000.0);
        order.into = folder / "both";
        order.version = "test";
        // In a room there is little way.
        order.mapping.loops.seekPartsEvery = 0.3;
    }
    /// It begins at @p seconds.
    std::filesystem::path write(const std::string& name, const std::vector<Pose>& places,
                                double seconds = 1.0) const {
        WrittenMission mission(folder / name);
        (void)writeRoom(mission, places, seconds);
        return folder / name;
    }
    /// The map of the new mission, as a station that opens it has it.
    [[nodiscard]] LiveMapPtr opened() const {
        LiveMapper mapper("station", {});
        const auto read = readMap(order.into);
        EXPECT_TRUE(read);
        EarlierMap earlier{keyScansOf(order.into), posesOf(read->state)};
        earlier.links = scanLinksOf(order.into);
        earlier.loops = loopsOf(read->state);
        restore(mapper, earlier);
        return mapper.map();
    }
    /// How far scans of @p map are from where they were taken, by the first one of the first mission [m].
    static double worst(const LiveMap& map) {
        std::vector<Pose> truth = alongTheRoom();
        const std::vector<Pose> second = backThroughTheRoom();
        truth.insert(truth.end(), second.begin(), second.end());
        const Pose roomInMap = map.scans.front().pose.scanInMap * truth.front().inverse();
        double largest = 0.0;
        for (std::size_t i = 0; i < map.scans.size(); ++i)
            largest = std::max(largest, distanceBetween(map.scans[i].pose.scanInMap, roomInMap * truth[i]));
        return largest;
    }

    TemporaryFolder folder;
    MergeOrder order;
};

TEST_F(MergedMaps, TwoThatSawTheSameAreOneMapAndTheirMissionsStayAsTheyAre) {
    const auto before = std::filesystem::last_write_time(order.first);
    const auto merged = mergeMaps(order);
    ASSERT_TRUE(merged) << merged.error().text;
    EXPECT_TRUE(merged->together);
    EXPECT_EQ(merged->first, 6U);
    EXPECT_EQ(merged->second, 6U);
    EXPECT_GE(merged->agreeing, 3U);
    const LiveMapPtr map = opened();
    ASSERT_EQ(map->scans.size(), 12U);
    EXPECT_FALSE(inParts(*map));
    EXPECT_THAT(worst(*map), Le(0.03));
    EXPECT_EQ(map->scans.front().scan->robot, "kurt3d@monday");
    EXPECT_EQ(map->scans.back().scan->robot, "kurt3d@tuesday");
    EXPECT_EQ(std::filesystem::last_write_time(order.first), before);
    EXPECT_EQ(keyScansOf(order.second).size(), 6U);
}

TEST_F(MergedMaps, AReviewOfItOpensWithTheWholeMap) {
    ASSERT_TRUE(mergeMaps(order));
    const auto player = ReviewPlayer::open(order.into).value();
    ASSERT_TRUE(waitUntil([&] { return player->moment() != nullptr; }, std::chrono::seconds(60)));
    EXPECT_EQ(player->moment()->map->scans.size(), 12U);
}

TEST_F(MergedMaps, WhatNothingOfIsSeenInTheOtherLiesBesideIt) {
    order.mapping.loops.partsAgree = 100;  // as where hardly a place is found
    const auto merged = mergeMaps(order);
    ASSERT_TRUE(merged) << merged.error().text;
    EXPECT_FALSE(merged->together);
    const LiveMapPtr map = opened();
    ASSERT_EQ(map->scans.size(), 12U);
    EXPECT_TRUE(inParts(*map));
    EXPECT_EQ(map->scans[0].part, 0U);
    for (std::size_t i = 6; i < 12; ++i) {
        EXPECT_EQ(map->scans[i].part, map->scans[6].id) << i;
        EXPECT_LT(map->scans[i].pose.scanInMap.translation().y(), -50.0) << i;
        if (i > 6) {
            EXPECT_GT(map->scans[i].matched, 6U) << i << ", of the second mission";
        }
    }
}

TEST_F(MergedMaps, AReportWarnsOfWhatHasNotMetTheRestWhateverAreaIsDrawn) {
    order.mapping.loops.partsAgree = 100;
    order.first = folder / "cropped";
    {
        WrittenMission mission(order.first);
        double seconds = 1.0;
        (void)writeRoom(mission, alongTheRoom(), seconds);
        mission.publish(seconds, std::string(station_topic::MapCrop),
                        MapCropSample{Time{}, "us", {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, 2.0});
    }
    ASSERT_TRUE(mergeMaps(order));
    const auto source = ReportSource::open(order.into);
    ASSERT_TRUE(source) << source.error().text;
    EXPECT_THAT(source->warnings(), testing::Contains(HasSubstr("6 of 12 scans are of parts")));
    ASSERT_EQ(source->input().scans.size(), 12U);
    for (const ReportScan& scan : source->input().scans)
        EXPECT_GT(scan.scan->points.size(), 1000U) << scan.id;
}

TEST_F(MergedMaps, MissionsOfOneNameAreToldApart) {
    std::filesystem::create_directory(folder / "later");
    order.second = write("later/monday", backThroughTheRoom());
    ASSERT_TRUE(mergeMaps(order));
    const LiveMapPtr map = opened();
    EXPECT_EQ(map->scans.front().scan->robot, "kurt3d@monday");
    EXPECT_EQ(map->scans.back().scan->robot, "kurt3d@monday-2");
}

TEST_F(MergedMaps, AMissionWithoutAMapIsNamedAndNothingIsLeftBehind) {
    WrittenMission(folder / "empty").publish(1.0, std::string(station_topic::Notes), NoteSample{});
    order.second = folder / "empty";
    const auto merged = mergeMaps(order);
    ASSERT_FALSE(merged);
    EXPECT_THAT(merged.error().text, HasSubstr("empty: expected a map of ours"));
    EXPECT_FALSE(std::filesystem::exists(order.into));
}

TEST_F(MergedMaps, TheEarlierMissionsMapStaysWhereItIsWhicheverIsNamedFirst) {
    std::swap(order.first, order.second);
    ASSERT_TRUE(mergeMaps(order));
    const LiveMapPtr map = opened();
    EXPECT_EQ(map->scans.front().scan->robot, "kurt3d@monday");
    EXPECT_EQ(map->scans.back().scan->robot, "kurt3d@tuesday");
}

TEST_F(MergedMaps, OneThatIsInPartsItselfIsMergedAll) {
    // Another place than both: nothing of it is found.
    MergeOrder apart = order;
    apart.into = folder / "parts";
    apart.mapping.loops.partsAgree = 100;
    ASSERT_TRUE(mergeMaps(apart));
    order.first = apart.into;
    order.second = write("wednesday", alongTheRoom(), 2.5e8);  // later than now
    const auto merged = mergeMaps(order);
    ASSERT_TRUE(merged) << merged.error().text;
    EXPECT_TRUE(merged->together) << "with its first part";
    EXPECT_EQ(merged->aside, 0U);
    const LiveMapPtr map = opened();
    ASSERT_EQ(map->scans.size(), 18U);
    EXPECT_EQ(map->scans[0].part, 0U);
    EXPECT_EQ(map->scans[6].part, map->scans[6].id) << "which had not met before, has not now";
    EXPECT_EQ(map->scans[12].part, 0U);
}

TEST_F(MergedMaps, MissionsOfOneNameAreToldApartHoweverTheyCame) {
    ASSERT_TRUE(mergeMaps(order));
    MergeOrder again = order;
    std::filesystem::create_directory(folder / "later");
    again.first = order.into;
    again.second = write("later/monday", alongTheRoom());
    again.into = folder / "all";
    ASSERT_TRUE(mergeMaps(again));
    std::set<std::string> robots;
    const auto read = readMap(again.into);
    for (const auto& [id, scan] : *read->state.keyScans) robots.insert(scan.entry.robot);
    EXPECT_THAT(robots, testing::UnorderedElementsAre("kurt3d@monday", "kurt3d@tuesday", "kurt3d@monday-2"));
}

TEST_F(MergedMaps, NoMissionIsMergedWithItself) {
    order.second = order.first / ".";
    const auto merged = mergeMaps(order);
    ASSERT_FALSE(merged);
    EXPECT_THAT(merged.error().text, HasSubstr("another mission"));
    EXPECT_FALSE(std::filesystem::exists(order.into));
}

TEST_F(MergedMaps, AMissionThatIsThereStaysAsItIs) {
    order.into = order.first;
    const auto merged = mergeMaps(order);
    ASSERT_FALSE(merged);
    EXPECT_THAT(merged.error().text, HasSubstr("monday: it is there already"));
    EXPECT_EQ(keyScansOf(order.first).size(), 6U);
}

TEST_F(MergedMaps, CancelledNothingIsLeftBehindHoweverFarItCame) {
    for (const double when : {0.0, 0.2, 0.4, 0.6, 0.94}) {
        std::stop_source stop;
        const auto report = [&](double share) {
            if (share >= when) stop.request_stop();
        };
        if (when == 0.0) stop.request_stop();
        EXPECT_FALSE(mergeMaps(order, {report, stop.get_token()})) << when;
        EXPECT_FALSE(std::filesystem::exists(order.into)) << when;
    }
    std::filesystem::create_directory(order.into);
    std::stop_source stop;
    const auto report = [&](double share) {
        if (share > 0.2) stop.request_stop();
    };
    EXPECT_FALSE(mergeMaps(order, {report, stop.get_token()}));
    EXPECT_TRUE(std::filesystem::is_empty(order.into)) << "somebody's own folder stays";
}

}  // namespace
}  // namespace leitstand::test
