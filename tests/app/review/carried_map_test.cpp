#include "app/services/recorded/carried_map.h"

#include <algorithm>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/recorded_map.h"
#include "core/event/station_topics.h"
#include "core/mission/state/undo.h"
#include "tests/app/review/written_room.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::Each;
using testing::Field;
using testing::HasSubstr;
using testing::SizeIs;

/// Yesterday's mission: six scans of a room, of which the third was set aside, and today's, which is new.
class CarriedMap : public testing::Test {
protected:
    void SetUp() override {
        WrittenMission mission(m_yesterday);
        double seconds = 1.0;
        std::vector<ScanPose> poses = writeRoom(mission, alongTheRoom(), seconds);
        poses[2].trust = ScanTrust::SetAside;
        poses[5].scanInMap.translation().x() += 0.01;  // as after a loop
        mission.publish(seconds, std::string(station_topic::ScanPoses),
                        ScanPosesSample{Time{}, "us", ScanPosesSample::Cause::Operator, poses});
        MapCropSample crop{Time{}, "us", {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, 2.0};
        mission.publish(seconds + 1.0, std::string(station_topic::MapCrop), crop);
        m_poses = poses;
    }
    [[nodiscard]] CarriedInto today() const { return {m_today, {}, "test"}; }
    /// The map of today's mission, as a station that opens it has it.
    [[nodiscard]] LiveMapper mapperOf() const {
        LiveMapper mapper("station", {});
        const auto read = readMap(m_today);
        EarlierMap earlier{keyScansOf(m_today), posesOf(read->state)};
        earlier.links = scanLinksOf(m_today);
        earlier.loops = loopsOf(read->state);
        restore(mapper, earlier);
        return mapper;
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_yesterday = m_folder / "yesterday", m_today = m_folder / "today";
    std::vector<ScanPose> m_poses;
};

TEST_F(CarriedMap, WhatCountsStandsInTheNewMissionAsItStoodAtTheEndOfTheOldOne) {
    const auto carried = carryMap(m_yesterday, today());
    ASSERT_TRUE(carried) << carried.error().text;
    EXPECT_EQ(*carried, 5U);
    const auto read = readMap(m_today);
    ASSERT_TRUE(read) << read.error().text;
    const std::vector<ScanPose> poses = posesOf(read->state);
    ASSERT_THAT(poses, SizeIs(5));
    for (const ScanPose& pose : poses) {
        const auto before = std::find_if(m_poses.begin(), m_poses.end(),
                                         [&](const ScanPose& one) { return one.scan == pose.scan; });
        EXPECT_TRUE(pose.scanInMap.isApprox(before->scanInMap, 1e-9)) << pose.scan;
        EXPECT_EQ(pose.trust, ScanTrust::Certain);
    }
    const auto crop = cropOf(read->state);
    ASSERT_TRUE(crop);
    EXPECT_DOUBLE_EQ(crop->ceiling, 2.0);
}

TEST_F(CarriedMap, TheRobotsOfTheNewMissionAreNowhereInItUntilItIsKnownWhereTheyStand) {
    ASSERT_TRUE(carryMap(m_yesterday, today()));
    LiveMapper mapper = mapperOf();
    EXPECT_THAT(mapper.map()->scans, SizeIs(5));
    EXPECT_THAT(mapper.map()->scans, Each(Field(&LiveKeyScan::part, 0U)))
        << "one map, also without the third";
    EXPECT_EQ(mapper.map()->scans.front().scan->robot, "kurt3d@yesterday");
    EXPECT_FALSE(mapper.fix("kurt3d"));
    const Pose here = poseFrom({1.0, 0.8, 0.9}, 0, 0, degrees(160));
    mapper.beginPart("kurt3d");
    const MapUpdate update = mapper.add(scanAt(here, 77), Time(std::chrono::seconds(9000)));
    ASSERT_TRUE(update.keyScan);
    EXPECT_EQ(update.keyScan->id, 7U) << "ids go on";
    EXPECT_EQ(mapper.map()->scans.back().part, 7U);
    const Pose roomInMap = poseFrom({-1.4, 0, 0.9}, 0, 0, 0).inverse();
    const auto question = mapper.propose(7, roomInMap * here, Time(std::chrono::seconds(9001)));
    ASSERT_TRUE(question) << question.error().text;
}

TEST_F(CarriedMap, WhatWasCarriedIsNoLoopThatKeysTakeBack) {
    ASSERT_TRUE(carryMap(m_yesterday, today()));
    const auto read = readMap(m_today);
    ASSERT_TRUE(read);
    EXPECT_FALSE(lastLoop(read->state));
    EXPECT_FALSE(undoable(read->state, "us"));
}

TEST_F(CarriedMap, AMissionThatHasAMapKeepsItAndOneWithoutHasNoneToGive) {
    ASSERT_TRUE(carryMap(m_yesterday, today()));
    const auto again = carryMap(m_yesterday, today());
    ASSERT_FALSE(again);
    EXPECT_THAT(again.error().text, HasSubstr("today: it is there already"));
    WrittenMission(m_folder / "empty").publish(1.0, std::string(station_topic::Notes), NoteSample{});
    EXPECT_TRUE(hasMap(m_yesterday).ok());
    EXPECT_FALSE(hasMap(m_folder / "empty").ok());
    EXPECT_FALSE(hasMap(m_folder / "absent").ok());
    const auto none = carryMap(m_folder / "empty", {m_folder / "new", {}, "test"});
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().text, HasSubstr("empty: expected a map of ours"));
    EXPECT_FALSE(carryMap(m_folder / "absent", {m_folder / "new", {}, "test"}));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "new"));
}

TEST_F(CarriedMap, CancelledNothingIsLeftBehind) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(carryMap(m_yesterday, today(), {{}, stop.get_token()}));
    EXPECT_FALSE(std::filesystem::exists(m_today));
}

}  // namespace
}  // namespace leitstand::test
