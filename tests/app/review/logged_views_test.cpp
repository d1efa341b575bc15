#include "app/services/coverage/logged_views.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/coverage/coverage_replay.h"
#include "app/services/coverage/coverage_watch.h"
#include "app/services/log/event_decoder.h"
#include "app/services/places/mission_map.h"
#include "app/services/recorded/review_log.h"
#include "core/event/map_samples.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"
#include "tests/app/review/written_mission.h"
#include "tests/core/mission/coverage/search_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

constexpr std::chrono::seconds Patience(60);

/// Kurt3D stands at (-2, 0) in the hall of SearchScene, scans it as key scan 1 after a second, and drives.
class LoggedViewsTest : public testing::Test {
protected:
    LoggedViewsTest() : m_mission(m_folder / "mission", 0.0) {
        m_mission.sayCamera(0.0);
        drive(0.0, 1.0, 0.0);
        KeyScanSample sample;
        const ReportScan seen = SearchScene{}.scan();
        auto scan = std::make_shared<Scan>(*seen.scan);
        scan->end = WrittenMission::at(1.0);
        sample.stamp = scan->end;
        sample.id = seen.id;
        sample.scan = scan;
        sample.sensorInBase = seen.sensorInBase;
        sample.scanInMap = seen.scanInMap;
        m_mission.publish(1.0, std::string(station_topic::KeyScans), sample);
    }
    /// From @p from to @p to [s], in that time to @p x of its odometry, with a picture every half second.
    void drive(double from, double to, double x) {
        const double begin = m_x;
        for (double t = from; t < to - 1e-6; t += 0.1) {
            m_x = begin + (x - begin) * (t + 0.1 - from) / (to - from);
            m_mission.sayPlace(t, m_x);
            if (std::lround(10 * t) % 5 == 0) m_mission.sayPicture(t, 50);
        }
    }
    /// Where a scan of the station said that the robot was, now.
    void place(double seconds, double x) {
        RobotPlaceSample sample;
        sample.stamp = sample.measured = WrittenMission::at(seconds);
        sample.robot = "kurt3d";
        sample.baseInMap = poseFrom({x, 0, 0}, 0, 0, 0);
        sample.certain = true;
        sample.certainty = 1.0;
        m_mission.publish(seconds, std::string(station_topic::RobotPlaces), sample);
    }
    [[nodiscard]] std::vector<SearchView> views() {
        m_mission.close();
        const LoggedViews logged = loggedViews(m_mission.folder());
        EXPECT_EQ(logged.leftOut, 0U);
        return logged.views;
    }
    [[nodiscard]] CoverageWatchSetup watching() const {
        CoverageWatchSetup setup;
        setup.robots = {WrittenMission::robot()};
        setup.poses = [] {
            return std::vector<ScanPose>{{.scan = 1, .scanInMap = SearchScene{}.scan().scanInMap}};
        };
        RobotInMap robot;
        robot.robot = "kurt3d";
        robot.placed = robot.certain = true;
        robot.certainty = 1.0;
        robot.stamp = WrittenMission::at(0.0);
        robot.baseInMap = poseFrom({-2.0, 0, 0}, 0, 0, 0);
        auto trail = std::make_shared<Trail>();
        for (const Eigen::Vector3d& step : SearchScene::trail()) trail->push_back({step.cast<float>()});
        robot.trail = trail;
        setup.places = [places = std::make_shared<const RobotsInMap>(RobotsInMap{robot})] { return places; };
        return setup;
    }

    const TemporaryFolder m_folder;
    WrittenMission m_mission;
    double m_x = 0.0;
};

TEST_F(LoggedViewsTest, HangOnTheScanThatTheRobotTook) {
    drive(1.0, 4.0, 0.6);
    const auto found = views();
    ASSERT_GE(found.size(), 3U);
    for (const SearchView& view : found) {
        EXPECT_EQ(view.scan, 1U);
        EXPECT_EQ(view.sensor, SearchSensor::Camera);
        EXPECT_LT(view.cameraInScan.translation().norm(), 1.2);
    }
}

TEST_F(LoggedViewsTest, AScanThatMovedAndWasPutBackIsWhereItWas) {
    drive(1.0, 2.0, 0.1);
    m_mission.moveKeyScan(2.0, 1, 3.0);
    const std::uint64_t moved = m_mission.sequence();
    drive(2.0, 3.0, 0.2);
    m_mission.sayUndo(3.0, moved);
    drive(3.0, 3.2, 0.2);
    place(3.15, -1.8);
    drive(3.2, 6.0, 0.8);
    const auto found = views();
    ASSERT_GE(found.size(), 4U);
    for (const SearchView& view : found) {
        EXPECT_LT(view.cameraInScan.translation().head<2>().norm(), 1.4)
            << "the robot was never farther from its scan";
    }
}

TEST_F(LoggedViewsTest, AScanThatWasSetAsideByMistakeCountsAgain) {
    drive(1.0, 2.0, 0.1);
    ScanPosesSample aside;
    aside.stamp = WrittenMission::at(2.0);
    aside.station = "test";
    aside.cause = ScanPosesSample::Cause::Operator;
    aside.poses = {{.scan = 1, .scanInMap = SearchScene{}.scan().scanInMap, .trust = ScanTrust::SetAside}};
    m_mission.publish(2.0, std::string(station_topic::ScanPoses), aside);
    const std::uint64_t decided = m_mission.sequence();
    drive(2.0, 3.0, 0.4);
    m_mission.sayUndo(3.0, decided);
    drive(3.0, 6.0, 1.0);
    const auto found = views();
    const auto farthest = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.cameraInScan.translation().x() < b.cameraInScan.translation().x();
    });
    ASSERT_NE(farthest, found.end());
    EXPECT_GT(farthest->cameraInScan.translation().x(), 0.9) << "what was seen after it counts again";
    EXPECT_TRUE(std::none_of(found.begin(), found.end(), [](const SearchView& view) {
        const double ahead = view.cameraInScan.translation().x();  // the camera is 0.19 m before the base
        return ahead > 0.4 && ahead < 0.55;
    })) << "in between it did not";
}

TEST_F(LoggedViewsTest, WhatWasSearchedIsThereAgainAfterARestart) {
    drive(1.0, 4.0, 0.7);
    const auto found = views();  // the station ends
    SearchBook book;
    book.add(SearchScene{}.scan());
    for (const SearchView& view : found) EXPECT_TRUE(book.add(view));
    std::vector<Eigen::Vector3d> trail = SearchScene::trail();
    const SearchedFloorPtr expected = searchedFloorOf(book.byStorey(trail));
    ASSERT_GT(expected->by(SearchSensor::Camera).seen, 1.0);
    const auto isSo = [&](const CoverageWatch& watch) {
        const auto now = watch.searched();
        return now && std::all_of(SearchSensors.begin(), SearchSensors.end(), [&](SearchSensor sensor) {
                   return std::abs(now->by(sensor).seen - expected->by(sensor).seen) < 1e-6 &&
                          now->by(sensor).missed.size() == expected->by(sensor).missed.size();
               });
    };

    // Live, by the events as they came.
    CoverageWatch live(watching());
    auto bag = BagReader::open(m_mission.folder());
    ASSERT_TRUE(bag);
    EventDecoder decoder({WrittenMission::robot()});
    BagCursor cursor = (*bag)->read();
    while (const auto raw = cursor.next())
        decoder.decode(*raw, [&](const Event& event) { live.onEvent(event); });
    EXPECT_TRUE(waitUntil([&] { return isSo(live); }, Patience));
    live.close();

    // Another station that goes on with the mission, and hears nothing yet.
    CoverageWatchSetup setup = watching();
    setup.earlier = keyScansOf(m_mission.folder());
    ASSERT_EQ(setup.earlier.size(), 1U);
    setup.earlierViews = [folder = m_mission.folder()](const std::stop_token& stop) {
        return loggedViews(folder, {.report = {}, .stop = stop}).views;
    };
    std::vector<std::string> reported;
    setup.notify = [&](const std::string& text) { reported.push_back(text); };
    CoverageWatch again(std::move(setup));
    EXPECT_TRUE(waitUntil([&] { return isSo(again); }, Patience));
    again.close();
    EXPECT_TRUE(reported.empty()) << reported.front();

    // It drives on: what was seen before the restart is not counted twice, and not forgotten.
    place(4.0, -1.3);
    drive(4.0, 6.0, 1.2);
    const auto more = views();
    EXPECT_GT(more.size(), found.size());
    EXPECT_LT(more.size(), 2 * found.size());
}

TEST_F(LoggedViewsTest, AMomentOfAReviewKnowsWhatWasSearchedByThen) {
    drive(1.0, 4.0, 0.7);
    m_mission.close();
    const auto log = ReviewLog::open(m_mission.folder());
    ASSERT_TRUE(log) << log.error().text;
    const ReviewIndexPtr index = indexOf(**log);
    const RobotsInMapPtr places = watching().places();
    const auto at = [&](double seconds) {
        const Time now = WrittenMission::at(seconds);
        return CoverageMoment{now, std::make_shared<const MissionState>((*log)->stateAt(now)), places, index};
    };
    CoverageReplay replay(m_mission.folder());
    EXPECT_EQ(replay.searched(), nullptr);
    replay.want(at(4.0));
    ASSERT_TRUE(waitUntil([&] { return replay.searched() != nullptr; }, Patience));
    const auto end = replay.searched();
    EXPECT_GT(end->by(SearchSensor::Camera).seen, 1.0);
    replay.want(at(1.05));
    ASSERT_TRUE(waitUntil([&] { return replay.searched() != end; }, Patience));
    const auto begin = replay.searched();
    EXPECT_GT(begin->by(SearchSensor::Scanner).seen, 1.0);
    EXPECT_EQ(begin->by(SearchSensor::Camera).seen, 0.0) << "no camera looked before";
    EXPECT_FALSE(begin->by(SearchSensor::Camera).missed.empty());
    replay.want(at(0.5));
    ASSERT_TRUE(waitUntil([&] { return replay.searched() == nullptr; }, Patience)) << "there was no map";
    replay.want(at(4.0));
    ASSERT_TRUE(waitUntil([&] { return replay.searched() != nullptr; }, Patience));
    EXPECT_EQ(replay.searched()->by(SearchSensor::Camera).seen, end->by(SearchSensor::Camera).seen);
}

TEST(LoggedViews, OfAMissionThatIsNotThereAreNone) {
    const TemporaryFolder folder;
    EXPECT_TRUE(loggedViews(folder / "none").views.empty());
}

}  // namespace
}  // namespace leitstand::test
