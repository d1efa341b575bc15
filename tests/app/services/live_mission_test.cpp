#include "app/services/log/live_mission.h"

#include <atomic>
#include <fstream>
#include <future>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/log/replay/bag_history.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/session_state.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

RobotDescription kurt() {
    RobotDescription robot;
    robot.name = "kurt3d";
    StreamDescription odometry;
    odometry.role = StreamRole::Odometry;
    odometry.topic = "/kurt3d/odom";
    odometry.type = "nav_msgs/msg/Odometry";
    robot.streams.push_back(odometry);
    return robot;
}

Time at(double seconds) {
    return Time(std::chrono::nanoseconds(1'700'000'000'000'000'000LL)) +
           std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

RawEvent odometryAt(double seconds) {
    OdometrySample sample;
    sample.header = {at(seconds), "kurt3d/odom"};
    sample.childFrame = "kurt3d/base_link";
    sample.baseInOdom.translation().x() = seconds;
    RawEvent event{0, at(seconds), "/kurt3d/odom", "nav_msgs/msg/Odometry", nullptr};
    event.cdr = encode(sample, event.type).value();
    return event;
}

FindSample victim(std::uint32_t number) {
    FindSample sample;
    sample.number = number;
    return sample;
}

class LiveMissionTest : public testing::Test {
protected:
    std::unique_ptr<LiveMission> begin(LiveMission::Listener listener = {}, double alarmMinutes = 10.0) {
        LiveMissionSettings settings;
        settings.folder = m_mission;
        settings.storage = m_storage;
        settings.alarmMinutes = alarmMinutes;
        settings.robots = {kurt()};
        settings.version = "test";
        auto mission = LiveMission::open(settings, std::move(listener));
        EXPECT_TRUE(mission.ok()) << mission.error().text;
        return mission ? std::move(mission).value() : nullptr;
    }
    std::vector<RawEvent> events(const std::string& topic = {}) const {
        std::vector<RawEvent> all;
        const auto bag = BagReader::open(m_mission);
        EXPECT_TRUE(bag.ok()) << bag.error().text;
        BagQuery query;
        if (!topic.empty()) query.topics = {topic};
        BagCursor cursor = (*bag)->read(query);
        while (auto event = cursor.next()) all.push_back(std::move(*event));
        return all;
    }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    std::optional<BagStorage> m_storage;
};

/// What holds in files of each kind.
class StoredLiveMission : public LiveMissionTest, public testing::WithParamInterface<BagStorage> {
protected:
    StoredLiveMission() { m_storage = GetParam(); }
};

TEST_P(StoredLiveMission, ACheckpointComesAtLeastEveryHalfMinuteAndAtTheEnd) {
    {
        const auto mission = begin();
        const Time begun = Time(std::chrono::system_clock::now().time_since_epoch());
        for (int i = 0; i < 600; ++i) {  // 150 s, one by one as they come in life
            RawEvent event = odometryAt(i);
            const Time received = event.received = begun + std::chrono::milliseconds(250 * i);
            mission->receive(std::move(event));
            while (mission->state()->last < received) std::this_thread::yield();
        }
        ASSERT_TRUE(mission->close().ok());
    }
    const auto all = events(), checkpoints = events(std::string(station_topic::Checkpoints));
    ASSERT_GE(checkpoints.size(), 6U);
    for (std::size_t i = 1; i < checkpoints.size(); ++i) {
        EXPECT_LE(checkpoints[i].received - checkpoints[i - 1].received, std::chrono::seconds(30));
    }
    EXPECT_EQ(all.back().topic, station_topic::Checkpoints);
}

TEST_P(StoredLiveMission, AResumeGoesOnFromTheStateThatWas) {
    std::uint64_t last = 0;
    {
        const auto mission = begin();
        for (int i = 1; i <= 50; ++i) mission->receive(odometryAt(i));
        EXPECT_TRUE(mission->record(victim(1), station_topic::Victims).ok());
        ASSERT_TRUE(mission->close().ok());
        last = mission->state()->sequence;
    }
    const auto mission = begin();
    EXPECT_THAT(*mission->state()->finds, SizeIs(1));
    EXPECT_EQ(mission->state()->robots.at("kurt3d")->odometry->sample.baseInOdom.translation().x(), 50.0);
    EXPECT_TRUE(
        mission
            ->record(UndoSample{.stamp = {},
                                .station = "",
                                .event = mission->state()->finds->at({FindSample::Kind::Victim, 1U}).sequence,
                                .text = ""},
                     station_topic::Undo)
            .ok());
    ASSERT_TRUE(mission->close().ok());
    EXPECT_THAT(*mission->state()->finds, IsEmpty());
    EXPECT_GT(mission->state()->sequence, last);
    EXPECT_THAT(*mission->state()->remarks, IsEmpty());
    EXPECT_THAT(*mission->state()->sessions, SizeIs(2));
}

TEST_P(StoredLiveMission, AnyJumpEqualsTheWholeReplay) {
    {
        const auto mission = begin();
        for (int i = 1; i <= 200; ++i) {
            RawEvent event = odometryAt(i);
            event.received =
                Time(std::chrono::system_clock::now().time_since_epoch()) + std::chrono::seconds(i);
            mission->receive(std::move(event));
            if (i % 10 != 0) continue;
            EXPECT_TRUE(mission->record(victim(static_cast<std::uint32_t>(i)), station_topic::Victims).ok());
        }
        ASSERT_TRUE(mission->close().ok());
    }
    const auto bag = std::move(BagReader::open(m_mission)).value();
    EventDecoder decoder({kurt()});
    BagHistory history(*bag, decoder);
    Fold whole;
    for (const RawEvent& raw : events()) {
        decoder.decode(raw, [&](const Event& event) { whole.add(event); });
        if (raw.sequence % 13 != 0) continue;
        ASSERT_EQ(serialised(stateAt(history, raw.sequence)), serialised(whole.state())) << raw.sequence;
    }
}

/// A pose as registration finds them: no quaternion gives back its matrix to the last bit.
Pose arbitraryPose(std::mt19937& random) {
    std::normal_distribution<double> any;
    Pose pose(Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized());
    pose.translation() = 10.0 * Eigen::Vector3d(any(random), any(random), any(random));
    return pose;
}

TEST_P(StoredLiveMission, TheStateOfALiveMissionIsToTheLastBitTheOneThatItsLogGives) {
    std::vector<std::byte> live;
    {
        const auto mission = begin();
        const auto record = [&](const Sample& sample, std::string_view topic) {
            ASSERT_TRUE(mission->record(sample, topic).ok());
        };
        int ofStations = 0;
        for (const SampleCase& one : sampleCases()) {
            if (one.role || one.sample.is<CheckpointSample>() || one.sample.is<SessionSample>()) continue;
            record(one.sample, "/leitstand/test_" + std::to_string(++ofStations));
        }
        EXPECT_GE(ofStations, 14);
        std::mt19937 random(7);
        for (std::uint64_t scan = 1; scan <= 300; ++scan) {
            RobotPlaceSample place;
            place.stamp = at(1.0);
            place.robot = "kurt3d";
            place.baseInMap = arbitraryPose(random);
            place.odomInMap = arbitraryPose(random);
            record(place, station_topic::RobotPlaces);
            ScanPosesSample poses{at(2.0), "a", ScanPosesSample::Cause::Registration, {}};
            poses.poses.push_back({.scan = scan, .scanInMap = arbitraryPose(random)});
            record(poses, station_topic::ScanPoses);
            FindSample find = victim(static_cast<std::uint32_t>(scan));
            find.positionInMap = arbitraryPose(random).translation();
            record(find, station_topic::Victims);
            mission->receive(odometryAt(static_cast<double>(scan) / 3.0));
        }
        ASSERT_TRUE(mission->close().ok());
        live = serialised(*mission->state());
    }
    EventDecoder decoder({kurt()});
    Fold fold;
    for (const RawEvent& raw : events()) decoder.decode(raw, [&](const Event& event) { fold.add(event); });
    EXPECT_TRUE(serialised(fold.state()) == live);
    EXPECT_GT(live.size(), 50'000U);
}

TEST_F(LiveMissionTest, ClosesWhileOthersStillSpeak) {
    const auto mission = begin();
    std::jthread speaker([&](const std::stop_token& stop) {
        for (int i = 1; !stop.stop_requested(); ++i) {
            mission->receive(odometryAt(i));
            std::this_thread::yield();
        }
    });
    while (mission->state()->robots.empty()) std::this_thread::yield();
    EXPECT_TRUE(mission->close().ok());
    speaker.request_stop();
    speaker.join();
    EXPECT_FALSE(events(std::string(station_topic::Checkpoints)).empty());
}

TEST_F(LiveMissionTest, WhatCannotBeReadOfEarlierSessionsIsTold) {
    {
        const auto mission = begin();
        for (int i = 1; i <= 500; ++i) mission->receive(odometryAt(i));
        ASSERT_TRUE(mission->close().ok());
    }
    std::filesystem::resize_file(m_mission / "mission_0.db3", 100'000);
    std::vector<std::string> reported;
    const auto mission = begin({.onAlarm = [&](const std::string& text) { reported.push_back(text); }});
    EXPECT_THAT(reported, testing::Contains(testing::HasSubstr("page by page")));
}

TEST_F(LiveMissionTest, AlarmsOfTheDiskAreInTheLog) {
    std::promise<void> reported;
    std::once_flag once;
    const auto mission = begin(
        {.onAlarm = [&](const std::string&) { std::call_once(once, [&] { reported.set_value(); }); }}, 1e15);
    std::atomic<bool> enough = false;
    std::jthread robot([&] {
        for (int i = 0; !enough; ++i) {
            mission->receive(odometryAt(0.001 * i));
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    EXPECT_EQ(reported.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
    enough = true;
    robot.join();
    ASSERT_TRUE(mission->close());
    ASSERT_FALSE(events(std::string(station_topic::Alarms)).empty());
    const MissionStatePtr state = mission->state();
    ASSERT_FALSE(state->alarms->empty());
    EXPECT_EQ(state->alarms->begin()->second.alarm.key, "disk_filling");
}

TEST_F(LiveMissionTest, RobotFilesOfEarlierSessionsStay) {
    ASSERT_TRUE(begin()->close());
    std::ofstream(m_mission / "robots/kurt3d.yaml") << "# as it was then\n";
    ASSERT_TRUE(begin()->close());
    std::ifstream earlier(m_mission / "robots/earlier/kurt3d-1.yaml");
    std::string line;
    std::getline(earlier, line);
    EXPECT_EQ(line, "# as it was then");
}

INSTANTIATE_TEST_SUITE_P(Storage, StoredLiveMission, testing::Values(BagStorage::Sqlite, BagStorage::Mcap),
                         [](const auto& one) { return std::string(nameOf(one.param)); });

}  // namespace
}  // namespace leitstand::test
