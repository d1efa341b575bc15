#include "app/services/station/station.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/station/station_scene.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/transport/link/control_robot.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

class StationTest : public StationScene {
protected:
    [[nodiscard]] std::uint64_t recorded(const std::string& topic) const {
        const auto bag = must(BagReader::open(m_folder / "station-mission"));
        BagQuery query;
        query.topics = {topic};
        BagCursor cursor = bag->read(query);
        std::uint64_t count = 0;
        while (cursor.next()) ++count;
        return count;
    }
};

TEST_F(StationTest, DrivesStopsAndReleasesARobot) {
    const RobotDescription description = drivenRobot();
    const auto node = nodeIn(m_domain);
    ControlRobot robot(*node, description);
    auto station = stationFor({description});
    ASSERT_TRUE(drive(*station, "kurt3d", {0.3, 0.0, 0.0}, [&] { return robot.speed() > 0.2; })) << words();
    EXPECT_TRUE(station->robot("kurt3d").grant.mine);
    EXPECT_EQ(station->robot("kurt3d").link.state, LinkState::Connected);

    station->stopAll();
    ASSERT_TRUE(waitUntil([&] { return robot.speed() == 0.0; }));
    ASSERT_TRUE(waitUntil([&] {
        const StopStatus stop = station->robot("kurt3d").stop;
        return stop.acknowledged && stop.stopped && stop.standing;
    }));
    EXPECT_FALSE(waitUntil(
        [&] {
            station->setStick({0.3, 0.0, 0.0});
            return robot.speed() != 0.0;
        },
        500ms))
        << "stopped";

    ASSERT_TRUE(waitUntil([&] { return station->release("kurt3d").ok(); }));
    ASSERT_TRUE(waitUntil([&] { return !station->robot("kurt3d").stop.stopped; }));
    EXPECT_FALSE(waitUntil(
        [&] {
            station->setStick({0.3, 0.0, 0.0});
            return robot.speed() != 0.0;
        },
        500ms))
        << "sticks must be neutral first";
    ASSERT_TRUE(drive(*station, "kurt3d", {0.3, 0.0, 0.0}, [&] { return robot.speed() > 0.2; }));

    station->setDriveFocus({});
    ASSERT_TRUE(waitUntil([&] { return robot.speed() == 0.0; })) << "without focus it stands";
    const MissionStatePtr state = station->mission();
    EXPECT_TRUE(state->robots.at("kurt3d")->odometry != nullptr);
    station.reset();
    EXPECT_GT(recorded("/kurt3d/odom"), 0u);
    EXPECT_GT(recorded("/kurt3d/cmd_vel"), 0u) << "what was said is in the log too";
    EXPECT_GT(recorded("/kurt3d/stop_cmd"), 1u);
    EXPECT_GT(recorded("/leitstand/grants"), 0u);
}

TEST_F(StationTest, OneRobotHasTheSticks) {
    const RobotDescription kurt = drivenRobot(), other = drivenRobot("crawler");
    const auto node = nodeIn(m_domain);
    ControlRobot first(*node, kurt), second(*node, other);
    const auto station = stationFor({kurt, other});
    ASSERT_TRUE(drive(*station, "kurt3d", {0.3, 0.0, 0.0}, [&] { return first.speed() > 0.2; }));
    ASSERT_TRUE(drive(*station, "crawler", {0.2, 0.0, 0.0}, [&] { return second.speed() > 0.1; }));
    EXPECT_TRUE(waitUntil([&] { return first.speed() == 0.0; }));
    EXPECT_FALSE(station->robot("kurt3d").drive.focus);
    EXPECT_TRUE(station->robot("kurt3d").grant.mine) << "the grant stays";
}

TEST_F(StationTest, RestartedItHasItsGrantBackAndGoesOnWithTheMission) {
    const RobotDescription description = drivenRobot();
    const auto node = nodeIn(m_domain);
    ControlRobot robot(*node, description);
    auto station = stationFor({description});
    ASSERT_TRUE(drive(*station, "kurt3d", {0.3, 0.0, 0.0}, [&] { return robot.speed() > 0.2; }));
    const auto before = station->mission()->events;
    station.reset();
    ASSERT_TRUE(waitUntil([&] { return robot.speed() == 0.0; }));
    station = stationFor({description});
    EXPECT_GE(station->mission()->events, before);
    EXPECT_TRUE(waitUntil([&] { return station->robot("kurt3d").grant.mine; }, 2s))
        << "no waiting for silence";
}

TEST_F(StationTest, TwoProgramsOfOneIdentityAreRefused) {
    const auto station = stationFor({drivenRobot()});
    StationSettings again;
    again.domain.domain = m_domain.number();
    again.mission.folder = m_folder / "another";
    again.mission.robots = {drivenRobot()};
    again.memory = m_folder / "station.yaml";
    const auto second = Station::open(again);
    ASSERT_FALSE(second.ok());
    EXPECT_THAT(second.error().text, testing::HasSubstr("station.yaml"));
}

TEST_F(StationTest, WishesThatARobotDoesNotTakeAreToldSo) {
    const auto station = stationFor({drivenRobot()});
    const auto mode = station->setMode("kurt3d", "explore");
    ASSERT_FALSE(mode.ok());
    EXPECT_THAT(mode.error().text, testing::HasSubstr("mode_command"));
    EXPECT_FALSE(station->setMode("nobody", "explore").ok());
    EXPECT_FALSE(station->robot("nobody").drive.drivable);
}

// Kurt3D as a process in a simulated arena.
TEST_F(StationTest, SeesDrivesAndCommandsASimulatedRobot) {
    const ChildProcess process(program("leitstand-robot"), {"kurt3d", "--arena", "yellow", "--seed", "7",
                                                            "--domain", std::to_string(m_domain.number())});
    std::atomic<int> clouds = 0, pictures = 0;
    const auto description = must(readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml"));
    const auto station = stationFor({description}, "station", [&](const Event& event) {
        if (event.sample.is<CloudSample>()) ++clouds;
        if (event.sample.is<PictureSample>()) ++pictures;
    });
    const auto view = [&] { return station->robot("kurt3d"); };
    ASSERT_TRUE(waitUntil([&] { return view().link.state == LinkState::Connected; }, 30s))
        << words() << process.out();
    // All around is known after a turn of the scanner, 2.3 s.
    const auto around = [&] { return station->surroundings("kurt3d"); };
    ASSERT_TRUE(waitUntil([&] { return around() && around()->oldest(-3.1, 3.1) < 10.0; }, 30s));
    EXPECT_LT(around()->nearest(-3.14, 3.14), 3.0) << "it stands in a cell of a maze";
    EXPECT_GT(clouds, 20);
    EXPECT_GT(pictures, 20);

    const auto turned = [&] {
        const auto odometry = station->mission()->robots.at("kurt3d")->odometry;
        return odometry && std::abs(odometry->sample.angular.z()) > 0.2;
    };
    ASSERT_TRUE(drive(*station, "kurt3d", {0.0, 0.0, 0.6}, turned));
    station->setStick({});
    ASSERT_TRUE(station->setMode("kurt3d", "explore").ok());
    ASSERT_TRUE(waitUntil([&] {
        const auto mode = station->mission()->robots.at("kurt3d")->mode;
        return mode && mode->sample.mode == "explore";
    })) << words();
    station->stop("kurt3d");
    ASSERT_TRUE(waitUntil([&] { return view().stop.acknowledged && view().stop.standing; }));
}

TEST_F(StationTest, ARestartedStationGoesOnWithItsMap) {
    const ChildProcess process(program("leitstand-robot"), {"kurt3d", "--arena", "yellow", "--seed", "7",
                                                            "--domain", std::to_string(m_domain.number())});
    const auto description = must(readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml"));
    RobotDescription bare = description;
    bare.sensors.clear();  // only tf_static tells where the scanner sits, and is said once
    auto station = stationFor({bare});
    ASSERT_TRUE(waitUntil([&] { return !station->mission()->keyScans->empty(); }, 60s)) << words();
    EXPECT_NEAR(station->mission()->keyScans->begin()->second.entry.sensorInBase.translation().z(), 0.48,
                0.01);
    station.reset();
    StationSettings again;
    again.domain.domain = m_domain.number();
    again.mission.folder = m_folder / "station-mission";
    again.mission.robots = {description};
    again.memory = m_folder / "station.yaml";
    std::atomic<std::size_t> shown = 0;
    StationListener listener;
    listener.onMap = [&](const MapPtr& map) { shown = map->scans.size(); };
    const auto resumed = must(Station::open(again, std::move(listener)));
    EXPECT_GE(shown, 1u) << "at once, before any scan";
    EXPECT_FALSE(resumed->mission()->keyScans->empty());
}

}  // namespace
}  // namespace leitstand::test
