#include "app/services/station/station_mapping.h"
#include "app/services/mapping/station_scanners.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/log/live_mission.h"
#include "app/services/log/sequencer.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/loops/open_loops.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/services/mapped_station.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

TEST_F(StationMappingTest, DecisionsAreInTheLogAndCanBeTakenBackAndDoneAgain) {
    begin();
    for (int i = 0; i < 3; ++i) scan();
    ASSERT_TRUE(scans(3)) << words();
    EXPECT_EQ(trust(3), ScanTrust::Certain);
    ASSERT_TRUE(m_mapping->reject(2).ok());
    ASSERT_TRUE(becomes(2, ScanTrust::SetAside));
    ASSERT_TRUE(m_mapping->rewind(Time{}).ok());
    ASSERT_TRUE(becomes(1, ScanTrust::SetAside));
    // Two at once: the second waits for the first.
    ASSERT_TRUE(m_mapping->undo().ok());
    ASSERT_TRUE(m_mapping->undo().ok());
    ASSERT_TRUE(becomes(2, ScanTrust::Certain)) << words();
    EXPECT_TRUE(becomes(1, ScanTrust::Certain));
    EXPECT_TRUE(waitUntil([&] { return !m_mapping->undo().ok(); })) << "nothing is left";
    ASSERT_TRUE(m_mapping->redo().ok());
    ASSERT_TRUE(becomes(2, ScanTrust::SetAside));
    EXPECT_EQ(trust(1), ScanTrust::Certain);
    ASSERT_TRUE(m_mapping->accept(2).ok());
    ASSERT_TRUE(becomes(2, ScanTrust::Certain));
    EXPECT_TRUE(waitUntil([&] { return !m_mapping->redo().ok(); })) << "something was decided since";
    scan();
    ASSERT_TRUE(scans(4));
    EXPECT_EQ(trust(4), ScanTrust::Certain) << "the robot goes on";
}

TEST_F(StationMappingTest, AScanThatDoesNotFitIsTriedAgain) {
    begin();
    for (int i = 0; i < 2; ++i) scan();
    scan(poseFrom({0.9, -0.7, 0}, 0, 0, degrees(25)));
    ASSERT_TRUE(scans(3)) << words();
    EXPECT_EQ(trust(3), ScanTrust::Uncertain);
    EXPECT_FALSE(m_mapping->robots()->front().certain);
    EXPECT_THAT(m_mapping->robots()->front().how, testing::Not(testing::IsEmpty()));
    RetrySettings settings;
    const LiveKeyScan first = m_mapping->scans()->scans.front();
    settings.guessInMap = first.pose.scanInMap * poseFrom({0.7, 0.1, 0}, 0, 0, 0);
    ASSERT_TRUE(m_mapping->retry(3, settings).ok());
    ASSERT_TRUE(becomes(3, ScanTrust::Certain)) << words();
    EXPECT_TRUE(waitUntil([&] { return m_mapping->robots()->front().certain; }));
}

/// A camera that measures depths looks ahead, narrowly, and says that all is 1 m nearer than it is.
class TwoScanners : public StationMappingTest {
protected:
    static constexpr const char* Front = "/kurt3d/front/points";

    void SetUp() override {
        m_robot.sensors["front"] = m_robot.sensors["laser"];
        StreamDescription front = m_robot.streams.front();
        front.topic = Front;
        front.sensor = "front";
        m_robot.streams.insert(m_robot.streams.begin(), front);
    }
    void scanWithBoth() {
        scan();
        CloudSample cloud;
        cloud.header = {m_time, "kurt3d/laser"};
        for (int y = -20; y <= 20; ++y)
            for (int z = -20; z <= 20; ++z)
                cloud.points.emplace_back(1.0F, 0.02F * float(y), 0.02F * float(z));
        publish(std::move(cloud), StreamRole::Points, Front);
    }
    [[nodiscard]] std::string mapsInFile() const {
        const auto kept = readRobot(m_folder / "mission" / "robots" / "kurt3d.yaml");
        const StreamDescription* const maps = kept ? kept->mappingStream() : nullptr;
        return maps != nullptr ? maps->topic : "";
    }
    /// The scanner's have some 9,000 points.
    [[nodiscard]] bool isOfCamera(const LiveKeyScan& scan) const {
        return scan.scan->points.size() <= 41 * 41;
    }
};

TEST_F(TwoScanners, OneMakesTheMapWhichIsSaidAndKeptAndTheOtherNeverEnters) {
    begin();
    for (int i = 0; i < 5; ++i) scanWithBoth();
    ASSERT_TRUE(scans(2)) << words();
    EXPECT_EQ(m_mapping->scanners().mapsWith("kurt3d"), "/kurt3d/points");
    EXPECT_THAT(words(), HasSubstr("/kurt3d/points"));
    EXPECT_EQ(mapsInFile(), "/kurt3d/points");
    const LiveMapPtr map = m_mapping->scans();
    for (const LiveKeyScan& scan : map->scans) {
        EXPECT_FALSE(isOfCamera(scan));
        EXPECT_EQ(scan.pose.trust, ScanTrust::Certain);
    }
}

TEST_F(TwoScanners, TheOperatorChoosesAnotherWhichStaysChosen) {
    begin();
    for (int i = 0; i < 4; ++i) scanWithBoth();
    ASSERT_TRUE(scans(1)) << words();
    EXPECT_THAT(m_mapping->scanners().mapWith("kurt3d", "/kurt3d/odom").error().text,
                HasSubstr("/kurt3d/odom"));
    m_granted = false;
    EXPECT_THAT(m_mapping->scanners().mapWith("kurt3d", Front).error().text, HasSubstr("another station"));
    m_granted = true;
    ASSERT_TRUE(m_mapping->scanners().mapWith("kurt3d", Front).ok());
    ASSERT_TRUE(waitUntil([&] { return m_mapping->scanners().mapsWith("kurt3d") == Front; }));
    const std::size_t before = m_mapping->scans()->scans.size();
    for (int i = 0; i < 3; ++i) scanWithBoth();
    ASSERT_TRUE(scans(before + 1)) << words();
    const LiveMapPtr map = m_mapping->scans();
    EXPECT_TRUE(isOfCamera(map->scans.back()));
    end();
    begin();
    EXPECT_EQ(m_mapping->scanners().mapsWith("kurt3d"), Front) << "the mission goes on with it";
    end();
    m_robot.streams.back().maps = true;
    begin();
    EXPECT_EQ(m_mapping->scanners().mapsWith("kurt3d"), Front) << "whatever the robot's file names";
}

TEST_F(StationMappingTest, TheTrailFollowsWhatIsDecidedOfScans) {
    begin();
    for (std::size_t i = 1; i <= 2; ++i) {
        scan();
        ASSERT_TRUE(scans(i)) << words();
    }
    scan(poseFrom({0.9, -0.7, 0}, 0, 0, degrees(25)));
    ASSERT_TRUE(scans(3)) << words();
    for (int i = 0; i < 10; ++i) {
        m_time += 50ms;
        odometry(basePose(m_way + 0.03 * (i + 1)) * m_slip);
    }
    const auto tip = [&] { return m_mapping->robots()->front().trail->back().inMap; };
    const auto here = [&] { return m_mapping->robots()->front(); };
    ASSERT_TRUE(waitUntil([&] { return here().stamp == m_time; }, 60s));
    const Eigen::Vector3f wrong = tip();
    EXPECT_LT((wrong - here().baseInMap.translation().cast<float>()).norm(), 0.11F);
    RetrySettings settings;
    const LiveKeyScan first = m_mapping->scans()->scans.front();
    settings.guessInMap = first.pose.scanInMap * poseFrom({0.7, 0.1, 0}, 0, 0, 0);
    ASSERT_TRUE(m_mapping->retry(3, settings).ok());
    ASSERT_TRUE(becomes(3, ScanTrust::Certain)) << words();
    EXPECT_TRUE(waitUntil([&] {
        return (tip() - here().baseInMap.translation().cast<float>()).norm() < 0.11F;
    })) << "its end goes along with the robot";
    EXPECT_GT((tip() - wrong).norm(), 0.3F);
}

TEST_F(StationMappingTest, OnlyTheHolderOfTheGrantDecidesAndScansWaitForIt) {
    m_granted = false;
    begin();
    scan();
    scan();
    EXPECT_THAT(m_mapping->reject(1).error().text, HasSubstr("another station"));
    EXPECT_THAT(m_mapping->undo().error().text, HasSubstr("another station"));
    EXPECT_TRUE(m_mapping->scans()->scans.empty());
    m_granted = true;
    scan();
    ASSERT_TRUE(scans(3)) << "those of the last seconds entered too; " << words();
    EXPECT_THAT(m_mapping->reject(17).error().text, HasSubstr("key scan 17"));
    EXPECT_THAT(m_mapping->rewind(stationTime() + 1h).error().text, HasSubstr("rewind"));
    // At once, or in words when what the scans said has come back.
    const auto undone = m_mapping->undo();
    EXPECT_TRUE(!undone.ok() ||
                waitUntil([&] { return words().find("nothing to be taken back") != std::string::npos; }, 60s))
        << words();
}

TEST_F(StationMappingTest, RobotsAreWhereTheirOdometryCarriesThemFromTheirNewestScan) {
    begin();
    EXPECT_FALSE(m_mapping->robots()->at(0).placed);
    for (std::size_t i = 1; i <= 3; ++i) {
        scan();
        ASSERT_TRUE(scans(i)) << words();
    }
    for (int i = 0; i < 10; ++i) {
        m_time += 50ms;
        odometry(basePose(m_way + 0.03 * (i + 1)) * m_slip);
    }
    const auto here = [&] { return m_mapping->robots()->front(); };
    // The map begins at the first scan: the scanner over the robot, 1.4 m into the room.
    ASSERT_TRUE(waitUntil([&] { return here().stamp == m_time && here().certain; }, 60s));
    EXPECT_TRUE(here().placed);
    EXPECT_LT((here().baseInMap.translation() - Eigen::Vector3d(1.1, 0, -0.9)).norm(), 0.03);
    EXPECT_GT(here().certainty, 0.5);
    EXPECT_GE(here().trail->size(), 6u);
    EXPECT_LT((here().trail->back().inMap - here().baseInMap.translation().cast<float>()).norm(), 0.11f);
}

TEST_F(StationMappingTest, WhatBelongsIntoTheMapIsTakenBackDoneAgainAndKept) {
    begin();
    scan();
    ASSERT_TRUE(scans(1)) << words();
    const auto farthestAhead = [&](std::size_t at) {
        const LiveKeyScan one = m_mapping->scans()->scans.at(at);
        double x = -100.0;
        for (const Eigen::Vector3f& point : one.scan->points) {
            if (point.allFinite()) x = std::max(x, (one.pose.scanInMap * point.cast<double>()).x());
        }
        return x;
    };
    const auto crop = [&] { return m_mapping->crop(); };
    const auto inLog = [&](std::size_t corners) {
        return waitUntil([&] {
            const auto reported = m_mission->state()->crop;
            return (reported ? reported->sample.polygon.size() : 0) == corners &&
                   crop().polygon.size() == corners;
        });
    };
    EXPECT_GT(farthestAhead(0), 1.5);
    EXPECT_TRUE(crop().open());
    MapCrop area;
    area.polygon = {{0.0, 0.0}, {1.0, 0.0}};
    EXPECT_FALSE(m_mapping->setCrop(area).ok()) << "two corners are no area";
    EXPECT_TRUE(crop().open());
    area.polygon = {{-10.0, -10.0}, {1.2, -10.0}, {1.2, 10.0}, {-10.0, 10.0}};
    ASSERT_TRUE(m_mapping->setCrop(area).ok());
    area.ceiling = 0.5;
    ASSERT_TRUE(m_mapping->setCrop(area).ok());
    ASSERT_TRUE(inLog(4));
    ASSERT_TRUE(waitUntil([&] { return farthestAhead(0) < 1.2 + 1e-6; })) << "also what is in the map";
    EXPECT_EQ(m_mapping->undoable()->kind, MapDecision::Kind::Crop);
    ASSERT_TRUE(m_mapping->undo().ok());
    ASSERT_TRUE(waitUntil([&] { return !(crop().ceiling < 1e9); })) << "as it was before";
    EXPECT_TRUE(inLog(4));
    ASSERT_TRUE(m_mapping->undo().ok());
    ASSERT_TRUE(inLog(0));
    ASSERT_TRUE(waitUntil([&] { return farthestAhead(0) > 1.5; })) << "it is back";
    EXPECT_FALSE(m_mapping->undoable().has_value());
    EXPECT_EQ(m_mapping->redoable()->kind, MapDecision::Kind::Crop);
    ASSERT_TRUE(m_mapping->redo().ok());
    ASSERT_TRUE(inLog(4));
    end();
    begin();
    EXPECT_EQ(crop().polygon, area.polygon) << "also after a restart";
    EXPECT_FALSE(crop().ceiling < 1e9);
    EXPECT_LT(farthestAhead(0), 1.2 + 1e-6);
    scan();
    ASSERT_TRUE(scans(2)) << words();
    EXPECT_LT(farthestAhead(1), 1.2 + 1e-6) << "what is outside stays out";
    ASSERT_TRUE(m_mapping->undo().ok()) << "also what was decided before";
    EXPECT_TRUE(inLog(0));
}

TEST_F(StationMappingTest, AStationThatStartsAgainHasTheMapTheRobotsAndWhatWasTakenBack) {
    begin();
    for (int i = 0; i < 3; ++i) scan();
    ASSERT_TRUE(scans(3)) << words();
    ASSERT_TRUE(m_mapping->reject(3).ok());
    ASSERT_TRUE(becomes(3, ScanTrust::SetAside));
    end();
    m_shown = 0;
    begin();
    EXPECT_EQ(m_shown, 3u);
    EXPECT_EQ(trust(3), ScanTrust::SetAside);
    EXPECT_TRUE(m_mapping->robots()->front().placed) << "where it was seen last";
    ASSERT_TRUE(m_mapping->undo().ok()) << "also what was decided before";
    EXPECT_TRUE(becomes(3, ScanTrust::Certain));
}

TEST_F(StationMappingTest, WhereTheMapMeetsItselfIsToldLoggedTakenBackAndClosedAgain) {
    closeLoops();
    begin();
    ASSERT_TRUE(closesOne()) << words();
    EXPECT_TRUE(mapIsAsLogged());
    const auto closed = posesInLog();
    EXPECT_GE(m_mission->state()->loops->size(), 2U);
    EXPECT_EQ(m_mapping->closedLoops().count, 1U);
    EXPECT_GT(m_mapping->closedLoops().largest, 0.0);
    EXPECT_FALSE(m_mapping->undoable().has_value()) << "it is no decision of the operator's";
    ASSERT_TRUE(m_mapping->undoLoop().ok());
    ASSERT_TRUE(waitUntil([&] { return m_mission->state()->loops->empty(); })) << words();
    ASSERT_TRUE(waitUntil([&] { return distanceBetween(posesInLog().back(), closed.back()) > 1e-6; }, 60s))
        << "scans are where they were before";
    EXPECT_TRUE(mapIsAsLogged());
    EXPECT_FALSE(m_mapping->undoLoop().ok()) << "nothing is left";
    ASSERT_TRUE(m_mapping->redo().ok());
    ASSERT_TRUE(waitUntil([&] { return distanceBetween(posesInLog().back(), closed.back()) < 1e-9; }, 60s))
        << words();
    EXPECT_TRUE(mapIsAsLogged());
}

TEST_F(StationMappingTest, AStationThatStartsAgainKnowsWhatClosedAndTakesItBack) {
    closeLoops();
    begin();
    ASSERT_TRUE(closesOne()) << words();
    ASSERT_TRUE(mapIsAsLogged());
    const auto closed = posesInLog();
    end();
    begin();
    ASSERT_TRUE(m_mapping->loop().has_value());
    EXPECT_TRUE(mapIsAsLogged());
    ASSERT_TRUE(m_mapping->undoLoop().ok());
    ASSERT_TRUE(waitUntil([&] { return distanceBetween(posesInLog().back(), closed.back()) > 1e-6; }, 60s))
        << words();
    EXPECT_TRUE(mapIsAsLogged());
}

TEST_F(StationMappingTest, WhereTheMapErredTooMuchItIsAskedAndTheAnswerTakenBack) {
    closeLoops();
    m_settings.loops.drift = m_settings.loops.driftAtLeast = 1e-7;  // nothing is expected to err
    begin();
    EXPECT_FALSE(m_mapping->answerLoop({}, true).ok()) << "nothing is asked";
    const auto asked = [&] { return openLoop(*m_mission->state()).has_value(); };
    for (std::size_t i = 1; i <= 20 && !asked(); ++i) {
        scan();
        ASSERT_TRUE(scans(i)) << words();
        (void)waitUntil(asked, 300ms);
    }
    ASSERT_TRUE(asked());
    EXPECT_THAT(words(), HasSubstr("is this a place that was seen before?"));
    EXPECT_FALSE(m_mapping->loop().has_value()) << "unanswered, nothing moves";
    const auto before = posesInLog();
    const OpenLoop loop = *openLoop(*m_mission->state());
    OpenLoop other = loop;
    ++other.event;
    EXPECT_FALSE(m_mapping->answerLoop(other, true).ok()) << "that is not what is asked";
    LoopPreviewPtr preview;
    ASSERT_TRUE(waitUntil([&] { return (preview = m_mapping->preview(loop)) != nullptr; }));
    EXPECT_FALSE(preview->moved.empty());
    EXPECT_EQ(posesInLog().size(), before.size()) << "to look what would move moves nothing";
    ASSERT_TRUE(m_mapping->answerLoop(loop, false).ok());
    ASSERT_TRUE(waitUntil([&] { return !asked(); }));
    EXPECT_EQ(posesInLog().size(), before.size());
    EXPECT_EQ(m_mapping->undoable()->kind, MapDecision::Kind::Refused);
    ASSERT_TRUE(m_mapping->undo().ok());
    ASSERT_TRUE(waitUntil(asked)) << "the question is open again";
    ASSERT_TRUE(m_mapping->answerLoop(loop, true).ok());
    ASSERT_TRUE(waitUntil([&] { return distanceBetween(posesInLog().back(), before.back()) > 1e-6; }, 60s))
        << words();
    EXPECT_EQ(m_mapping->undoable()->kind, MapDecision::Kind::Loop) << "it was the operator's act";
    for (const auto& [scan, pose] : preview->moved) {
        const Pose now = m_mission->state()->keyScans->at(scan).pose.scanInMap;
        EXPECT_LT(distanceBetween(now, pose), 1e-9) << "scan " << scan << " went where the preview had it";
    }
    EXPECT_TRUE(mapIsAsLogged());
}

TEST_F(StationMappingTest, TheOperatorShowsAPlaceThatAScanMeetsAndIsAskedBeforeTheMapMoves) {
    closeLoops();
    begin();
    ASSERT_TRUE(closesOne()) << words();
    ASSERT_TRUE(m_mapping->undoLoop().ok());
    // Its poses come after it: what is asked before they do is answered by them.
    ASSERT_TRUE(waitUntil([&] {
        const MissionStatePtr now = m_mission->state();
        return now->loops->empty() && std::holds_alternative<ScanPosesSample>(now->decisions->back().content);
    })) << words();
    const LiveMapPtr map = m_mapping->scans();
    const ScanPose last = map->scans.back().pose;
    EXPECT_FALSE(m_mapping->propose(last.scan + 1, last.scanInMap).ok()) << "there is no such scan";
    ASSERT_TRUE(m_mapping->propose(last.scan, poseFrom({40, 40, 0}, 0, 0, 0)).ok());
    ASSERT_TRUE(waitUntil([&] { return words().find("no older part of the map") != std::string::npos; }))
        << words();
    ASSERT_TRUE(m_mapping->propose(last.scan, last.scanInMap).ok());
    const auto asked = [&] { return openLoop(*m_mission->state()).has_value(); };
    ASSERT_TRUE(waitUntil(asked)) << words();
    EXPECT_FALSE(m_mapping->loop().has_value()) << "nothing moves yet";
    const auto before = posesInLog();
    ASSERT_TRUE(m_mapping->answerLoop(*openLoop(*m_mission->state()), true).ok());
    ASSERT_TRUE(waitUntil([&] { return distanceBetween(posesInLog().back(), before.back()) > 1e-6; }, 60s))
        << words();
    EXPECT_EQ(m_mapping->undoable()->kind, MapDecision::Kind::Loop);
    EXPECT_TRUE(mapIsAsLogged());
}

}  // namespace
}  // namespace leitstand::test
