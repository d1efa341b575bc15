#include "app/services/review/map_tidying.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/review_log.h"
#include "core/event/station_topics.h"
#include "core/mission/state/scan_state.h"
#include "core/mission/state/session_state.h"
#include "tests/app/review/written_room.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

constexpr int Scans = 6;

/// Where the scanner is on a circle of 6 m in the furnished room, in the frame of the first place.
Pose onCircle(int place) {
    const double angle = 0.4 * place;
    return poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2);
}
Pose inMap(int place) {
    return onCircle(0).inverse() * onCircle(place);
}

/// A mission whose map is off by some centimetres.
class TidyingTest : public testing::Test {
protected:
    void SetUp() override {
        WrittenMission mission(m_folder / "mission");
        double seconds = 1.0;
        std::vector<Pose> places;
        for (int place = 0; place < Scans; ++place) places.push_back(onCircle(place));
        std::vector<ScanPose> poses = writeRoom(mission, places, seconds);
        for (std::size_t i = 1; i < poses.size(); ++i) {
            const double off = i % 2 == 0 ? 0.05 : -0.04;
            poses[i].scanInMap = poses[i].scanInMap * poseFrom({off, -off, 0}, 0, 0, 0.2 * off);
        }
        mission.publish(seconds, std::string(station_topic::ScanPoses),
                        ScanPosesSample{Time{}, "us", ScanPosesSample::Cause::Registration, poses});
        mission.publish(seconds + 1.0, std::string(station_topic::Notes),
                        NoteSample{WrittenMission::at(seconds + 1.0), "us", "", "done"});
    }
    [[nodiscard]] std::filesystem::path folder() const { return m_folder / "mission"; }
    [[nodiscard]] MissionState state() const {
        const auto log = ReviewLog::open(folder()).value();
        return log->stateAt(log->last());
    }
    [[nodiscard]] std::vector<Pose> poses() const {
        std::vector<Pose> found;
        for (const ScanPose& pose : posesOf(state())) found.push_back(pose.scanInMap);
        return found;
    }
    [[nodiscard]] double error() const {
        double most = 0.0;
        const auto found = poses();
        for (std::size_t i = 0; i < found.size(); ++i)
            most = std::max(most, distanceBetween(found[i], inMap(static_cast<int>(i))));
        return most;
    }
    /// Links by their ids, as they are now.
    [[nodiscard]] std::map<std::uint64_t, bool> links() const {
        std::map<std::uint64_t, bool> active;
        for (const ScanLinksSample& sample : scanLinksOf(folder())) {
            for (const Link& link : sample.links) active[link.id] = link.active;
        }
        return active;
    }
    [[nodiscard]] std::size_t sessions() const { return state().sessions->size(); }
    const TemporaryFolder m_folder;
};

TEST_F(TidyingTest, PutsScansWhereSurfacesWantThemAndIsTakenBackAsItWas) {
    const auto before = poses();
    const auto held = links();
    ASSERT_GT(error(), 0.05);
    const auto tidied = tidyMap(folder());
    ASSERT_TRUE(tidied) << tidied.error().text;
    EXPECT_EQ(tidied->scans, std::size_t{Scans});
    EXPECT_EQ(tidied->moved, std::size_t{Scans - 1});
    EXPECT_LT(error(), 0.008);
    EXPECT_EQ(state().keyScans->size(), std::size_t{Scans}) << "what was recorded is there";
    EXPECT_EQ(state().notes->size(), 1U);

    const auto again = tidyMap(folder());
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_EQ(again->moved, 0U) << "it is tidy";

    ASSERT_TRUE(untidyMap(folder(), "test"));
    const auto after = poses();
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i].matrix(), before[i].matrix()) << i;
    for (const auto& [id, active] : links()) {
        const auto known = held.find(id);
        EXPECT_EQ(active, known != held.end() && known->second) << id;
    }
    EXPECT_THAT(untidyMap(folder(), "test").error().text, HasSubstr("was not tidied"));
}

TEST_F(TidyingTest, AMapOfBeforeThereWereLinksGetsThemThoughNothingMoves) {
    const std::filesystem::path old = m_folder / "old";
    {
        WrittenMission mission(old);
        double seconds = 1.0;
        std::vector<Pose> places;
        for (int place = 0; place < Scans; ++place) places.push_back(onCircle(place));
        writeRoom(mission, places, seconds, false);
    }
    ASSERT_TRUE(scanLinksOf(old).empty());
    TidySettings settings;
    settings.mapping.loops.noticed = 0.05;  // matches move scans by millimetres
    const auto tidied = tidyMap(old, settings);
    ASSERT_TRUE(tidied) << tidied.error().text;
    EXPECT_EQ(tidied->moved, 0U);
    EXPECT_GE(tidied->linked, std::size_t{Scans - 1});
    EXPECT_THAT(tidiedText(*tidied), HasSubstr("links now"));
    ASSERT_FALSE(scanLinksOf(old).empty());
    const auto again = tidyMap(old, settings);
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_EQ(again->linked, 0U) << "it has them";
    ASSERT_TRUE(untidyMap(old, "test"));
    const auto remade = tidyMap(old, settings);
    ASSERT_TRUE(remade) << remade.error().text;
    EXPECT_GE(remade->linked, std::size_t{Scans - 1}) << "they were taken back";
}

TEST_F(TidyingTest, AStationThatGoesOnHasTheTidiedMapAndWhatHoldsIt) {
    ASSERT_TRUE(tidyMap(folder()));
    const MissionState now = state();
    EarlierMap earlier{keyScansOf(folder()), posesOf(now)};
    earlier.links = scanLinksOf(folder());
    LiveMapper mapper("us", {});
    restore(mapper, earlier);
    // As where a loop was closed or taken back since.
    Link refused;
    refused.id = 4'711;
    refused.from = 1;
    refused.to = Scans;
    refused.kind = LinkKind::Operator;
    refused.active = false;
    mapper.restore(ScanLinksSample{Time{}, "us", {refused}});
    const auto problem = mapper.problem();
    ASSERT_TRUE(problem);
    (void)mapper.settle(solve(*problem), Time{});
    const LiveMapPtr map = mapper.map();
    for (std::size_t i = 0; i < map->scans.size(); ++i)
        EXPECT_LT(distanceBetween(map->scans[i].pose.scanInMap, inMap(static_cast<int>(i))), 0.008) << i;
}

TEST_F(TidyingTest, CancelledNothingIsWritten) {
    std::stop_source stop;
    stop.request_stop();
    const auto before = poses();
    const std::size_t written = sessions();
    const auto tidied = tidyMap(folder(), {}, {{}, stop.get_token()});
    ASSERT_FALSE(tidied);
    EXPECT_THAT(tidied.error().text, HasSubstr("as it was"));
    EXPECT_EQ(poses().back().matrix(), before.back().matrix());
    EXPECT_EQ(sessions(), written) << "not even a session";
    EXPECT_FALSE(untidyMap(folder(), "test"));
    EXPECT_EQ(sessions(), written);
}

TEST_F(TidyingTest, IsNotTakenBackOnceScansEnteredTheTidiedMap) {
    ASSERT_TRUE(tidyMap(folder()));
    MappedRoom room;
    const MapUpdate update = room.add(onCircle(Scans));
    KeyScanSample later = *update.keyScan;
    later.id = Scans + 1;
    {
        LiveMissionSettings settings;
        settings.folder = folder();
        settings.station = "us";
        settings.robots = {WrittenMission::robot()};
        const auto mission = LiveMission::open(settings);
        ASSERT_TRUE(mission) << mission.error().text;
        ASSERT_TRUE((*mission)->record(later, station_topic::KeyScans));
        ASSERT_TRUE((*mission)->close());
    }
    EXPECT_THAT(untidyMap(folder(), "test").error().text, HasSubstr("the tidied map went on since"));
}

TEST_F(TidyingTest, NamesAMissionWithoutAMap) {
    {
        WrittenMission empty(m_folder / "empty");
        empty.sayOdometry(1.0, 0.0);
    }
    EXPECT_THAT(tidyMap(m_folder / "empty").error().text, HasSubstr("found no key scans"));
    EXPECT_THAT(tidyMap(m_folder / "absent").error().text, HasSubstr("absent"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "absent")) << "nothing is made";
}

}  // namespace
}  // namespace leitstand::test
