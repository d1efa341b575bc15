// Robots as their makers ship them: what they publish and take, and what the programs make of it unasked.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/log/decoded_log.h"
#include "app/services/log/event_decoder.h"
#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/event/command_samples.h"
#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/event/raw_event.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "tests/app/recording.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/temporary_folder.h"
#include "transport/convert/encode.h"
#include "transport/link/stop_sender.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

/// What `probe` says of a domain: robots, and what each topic is used for.
struct Probed {
    std::map<std::string, std::string> files;                         ///< robot -> file
    std::map<std::string, std::pair<std::string, std::string>> uses;  ///< topic -> robot, role
    std::set<std::string> types;
    std::string text;
};

Probed probed(const TestDomain& domain, const std::filesystem::path& folder) {
    const auto probe = leitstandctl({"probe", "--domain", std::to_string(domain.number()), "--seconds", "4",
                                     "--out", folder.string(), "--json"});
    EXPECT_EQ(probe.exitCode, 0) << probe.err;
    Probed all{{}, {}, {}, probe.out + probe.err};
    const json report = json::parse(probe.out);
    for (const json& robot : report["robots"]) all.files[robot["name"]] = robot["file"];
    for (const json& topic : report["topics"]) {
        all.uses[topic["topic"]] = {topic["robot"], topic["role"]};
        all.types.insert(topic["type"]);
    }
    return all;
}

TEST(StockRobots, ATurtleBot4IsOneRobotWithWhatTheStationCanUse) {
    const TemporaryFolder folder;
    const TestDomain domain;
    const RobotProcess robot(domain, "stock", {"turtlebot4"});
    const Probed found = probed(domain, folder.path());
    ASSERT_EQ(found.files.size(), 1U) << found.text;
    const auto use = [&](const std::string& topic) { return found.uses.at(topic).second; };
    EXPECT_EQ(use("/scan"), "ranges");
    EXPECT_EQ(use("/odom"), "odometry");
    EXPECT_EQ(use("/cmd_vel"), "drive_command");
    EXPECT_EQ(use("/oakd/rgb/preview/image_raw/compressed"), "picture");
    EXPECT_EQ(use("/oakd/rgb/preview/image_raw"), "") << "it is the same camera";
    EXPECT_EQ(use("/oakd/stereo/image_raw"), "") << "depths, and it has a laser";
    EXPECT_EQ(use("/oakd/stereo/camera_info"), "") << "its pictures are not used";
    EXPECT_EQ(use("/battery_state"), "battery");
    EXPECT_EQ(use("/tf"), "transforms");
    for (const std::string& type : found.types) EXPECT_FALSE(type.starts_with("leitstand_msgs/")) << type;
    const RobotDescription written = must(readRobot(found.files.begin()->second));
    EXPECT_EQ(written.stream(StreamRole::DriveCommand)->type, "geometry_msgs/msg/TwistStamped");
    EXPECT_GT(written.stream(StreamRole::DriveCommand)->qos.lifespan, 0.0);
    EXPECT_EQ(written.sensors.size(), 1U) << "one camera";
    std::map<std::string, std::optional<bool>> services;
    for (const ServiceDescription& service : written.services) services[service.name] = service.stop;
    EXPECT_EQ(services.size(), 6U) << found.text;
    EXPECT_EQ(services.at("/oakd/stop_camera"), std::nullopt);
    EXPECT_EQ(services["/e_stop"], true);
    EXPECT_EQ(services["/follow_waypoints/_action/cancel_goal"], true);
    ASSERT_NE(written.navigation(), nullptr) << found.text;
    EXPECT_EQ(written.navigation()->name, "/navigate_to_pose");
    EXPECT_TRUE(written.takesGoals());
}

TEST(StockRobots, TwoOfOneKindAreToldApartByTheirNamespaces) {
    const TemporaryFolder folder;
    const TestDomain domain;
    const RobotProcess one(domain, "stock", {"turtlebot4", "--namespace", "tb1"});
    const RobotProcess two(domain, "stock", {"turtlebot4"});
    const Probed found = probed(domain, folder.path());
    ASSERT_EQ(found.files.size(), 2U) << found.text;
    EXPECT_EQ(found.uses.at("/tb1/scan").first, "tb1");
    EXPECT_EQ(found.uses.at("/tb1/tf").first, "tb1");
    EXPECT_NE(found.uses.at("/scan").first, "tb1");
    EXPECT_EQ(found.uses.at("/scan").first, found.uses.at("/cmd_vel").first);
    EXPECT_EQ(found.uses.at("rq/tb1/e_stopRequest").first, "tb1");
    EXPECT_EQ(found.uses.at("rq/e_stopRequest").first, found.uses.at("/scan").first);
}

/// A robot with a 3D scanner: what probe calls it, and how it is registered.
struct Scanning {
    std::string profile, found;
    std::vector<std::string> registering;
};
std::ostream& operator<<(std::ostream& out, const Scanning& one) {
    return out << one.profile;
}

class ScanningStockRobots : public testing::TestWithParam<Scanning> {};
INSTANTIATE_TEST_SUITE_P(, ScanningStockRobots,
                         testing::Values(Scanning{"husky", "a200_0000", {}}, Scanning{"ouster", "robot", {}},
                                         // Of one frame it sees little, each time something else.
                                         Scanning{"livox", "robot", {"--reference", "map"}}),
                         [](const auto& given) { return given.param.profile; });

TEST_P(ScanningStockRobots, AreMappedFromWhatProbeWroteOfThem) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    const TestDomain domain;
    Truth truth(domain, "yellow_7", "");
    const RobotProcess process(domain, "stock", {GetParam().profile, "--seed", "7"});
    ASSERT_TRUE(truth.listener().receives(truth.topic("kurt3d")));
    const Probed found = probed(domain, folder.path());
    ASSERT_EQ(found.files.size(), 1U) << found.text;
    ASSERT_EQ(found.files.begin()->first, GetParam().found);
    const std::string file = found.files.begin()->second;
    const RobotDescription robot = must(readRobot(file));
    const StreamDescription* const scanner = robot.stream(StreamRole::Points);
    ASSERT_NE(scanner, nullptr) << found.text;
    Recording recording(domain, mission, {"--robot", file});
    ASSERT_TRUE(waitUntil([&] { return recordedOn(mission, scanner->topic).size() > 30; }, 90s));
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    const Registered registered =
        registerAgainst(truth, mission, shippedRobot(GetParam().profile), GetParam().registering);
    EXPECT_THAT(registered.problems, testing::IsEmpty());
    std::printf("standing: %d scans, worst %.1f mm and %.2f degrees off\n", registered.scans,
                1e3 * registered.worstPosition, inDegrees(registered.worstTurn));
    EXPECT_GE(registered.scans, 20) << "each revolution is a scan";
    EXPECT_LT(registered.worstPosition, 0.03);
    EXPECT_LT(registered.worstTurn, degrees(1.0));
}

TEST(StockRobots, DepthsOfATurtleBot4AreCloudsWhereItsFileNamesThem) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    const TestDomain domain;
    const RobotProcess process(domain, "stock", {"turtlebot4"});
    RobotDescription robot = shippedRobot("turtlebot4");
    robot.sensors["stereo"].frame = "oakd_right_camera_optical_frame";
    for (const auto& [role, topic, type] :
         {std::tuple(StreamRole::Points, "/oakd/stereo/image_raw/compressedDepth",
                     "sensor_msgs/msg/CompressedImage"),
          std::tuple(StreamRole::CameraInfo, "/oakd/stereo/camera_info", "sensor_msgs/msg/CameraInfo")}) {
        StreamDescription stream;
        stream.role = role;
        stream.sensor = "stereo";
        stream.topic = topic;
        stream.type = type;
        stream.qos.reliability = Qos::Reliability::BestEffort;
        robot.streams.push_back(stream);
    }
    const auto file = folder / "depths.yaml";
    writeText(file, writeRobot(robot));
    Recording recording(domain, mission, {"--robot", file.string()});
    const std::string depths = "/oakd/stereo/image_raw/compressedDepth";
    ASSERT_TRUE(waitUntil([&] { return recordedOn(mission, depths).size() > 10; }, 90s)) << recording.out();
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    auto bag = BagReader::open(mission);
    ASSERT_TRUE(bag) << bag.error().text;
    EventDecoder decoder({robot});
    BagQuery query;
    query.topics = {depths};
    int clouds = 0;
    forEachEvent(**bag, decoder, query, [&](const Event& event) {
        const auto* const cloud = event.sample.as<CloudSample>();
        ASSERT_NE(cloud, nullptr);
        EXPECT_GT(cloud->points.size(), 1'000U);
        for (const Eigen::Vector3f& point : cloud->points) EXPECT_GT(point.z(), 0.3F);
        ++clouds;
    });
    EXPECT_GT(clouds, 5);
    EXPECT_TRUE(decoder.errors().empty());
}

TEST(StockRobots, WhatAnOusterMakesOfItsScansIsNoCamera) {
    const TemporaryFolder folder;
    const TestDomain domain;
    const RobotProcess robot(domain, "stock", {"ouster"});
    const Probed found = probed(domain, folder.path());
    ASSERT_EQ(found.files.size(), 1U) << found.text;
    const auto use = [&](const std::string& topic) { return found.uses.at(topic).second; };
    EXPECT_EQ(use("/ouster/points"), "points");
    EXPECT_EQ(use("/ouster/imu"), "imu");
    for (const char* image : {"range", "signal", "reflec", "nearir"})
        EXPECT_EQ(use("/ouster/" + std::string(image) + "_image"), "") << found.text;
    const RobotDescription written = must(readRobot(found.files.begin()->second));
    EXPECT_EQ(written.stream(StreamRole::Picture), nullptr);
    EXPECT_NE(written.stream(StreamRole::DriveCommand), nullptr);
}

TEST(StockRobots, ATrackedOneSendsItsCameraAsAVideo) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    const TestDomain domain;
    const RobotProcess process(domain, "stock", {"tracked"});
    const Probed found = probed(domain, folder.path());
    ASSERT_EQ(found.files.size(), 1U) << found.text;
    EXPECT_EQ(found.uses.at("/camera/image_raw/ffmpeg").second, "picture");
    EXPECT_EQ(found.uses.at("/camera/image_raw").second, "") << "the same camera";
    const std::string file = found.files.begin()->second;
    const RobotDescription robot = must(readRobot(file));
    EXPECT_EQ(robot.sensors.size(), 1U) << "one camera";
    std::map<std::string, std::optional<bool>> services;
    for (const ServiceDescription& service : robot.services) services[service.name] = service.stop;
    EXPECT_EQ(services.at("/e_stop"), true);
    EXPECT_EQ(services.at("/lamp"), std::nullopt);
    Recording recording(domain, mission, {"--robot", file});
    const std::string camera = robot.stream(StreamRole::Picture)->topic;
    ASSERT_TRUE(waitUntil([&] { return recordedOn(mission, camera).size() > 30; }, 90s)) << recording.out();
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    EventDecoder decoder({robot});
    PictureDecoder pictures;
    int shown = 0, waited = 0;
    for (const Payload& payload : recordedOn(mission, camera)) {
        RawEvent raw;
        raw.topic = camera;
        raw.type = robot.stream(StreamRole::Picture)->type;
        raw.cdr = payload;
        decoder.decode(raw, [&](const Event& event) {
            const auto picture = pictures.decode(event.sample.get<PictureSample>());
            ++(picture ? shown : waited);
            if (picture) {
                EXPECT_GT(picture->width, 100);
            }
        });
    }
    EXPECT_GT(shown, 20);
    EXPECT_LE(waited, 10) << "up to the first key picture";
}

/// A node that drives a TurtleBot 4 without asking anybody, and sees it turn.
class Driver {
public:
    Driver(Node& node, const RobotDescription& robot)
        : m_listener(node, {*robot.stream(StreamRole::Odometry)}),
          m_wheel(must(node.publisher({.topic = "/cmd_vel",
                                       .type = "geometry_msgs/msg/TwistStamped",
                                       .qos = robot.stream(StreamRole::DriveCommand)->qos}))) {
        TwistSample turn;
        turn.angular.z() = 0.6;
        m_command = must(encode(turn, "geometry_msgs/msg/TwistStamped"));
    }
    [[nodiscard]] bool isConnected() {
        return m_listener.receives("/odom") && waitUntil([&] { return m_wheel->matched() > 0; });
    }
    [[nodiscard]] OdometrySample newest() { return m_listener.all<OdometrySample>("/odom").back(); }
    [[nodiscard]] bool isTurning() { return std::abs(newest().angular.z()) > 0.3; }
    /// Drives until @p done, for 20 s at most.
    template <class Done>
    [[nodiscard]] bool until(Done done) {
        return waitUntil([&] {
            (void)m_wheel->write(m_command);
            std::this_thread::sleep_for(50ms);
            return done();
        });
    }

private:
    RobotListener m_listener;
    std::unique_ptr<Publisher> m_wheel;
    Payload m_command;
};

TEST(StockRobots, ItsEStopStopsItWhoeverDrivesOn) {
    const TestDomain domain;
    const RobotProcess process(domain, "stock", {"turtlebot4"});
    const auto node = nodeIn(domain), station = nodeIn(domain);
    const RobotDescription robot = shippedRobot("turtlebot4");
    const auto stops = must(StopSender::create(*station, std::vector{robot},
                                               {.mayRelease = [](const std::string&) { return true; }}));
    Driver other(*node, robot);
    ASSERT_TRUE(other.isConnected());
    ASSERT_TRUE(other.until([&] { return other.isTurning(); }));
    ASSERT_TRUE(waitUntil([&] { return stops->status(robot.name).services.front().offered; }));
    stops->stopAll();
    EXPECT_TRUE(other.until([&] { return stops->status(robot.name).standing; })) << "the other one drives on";
    for (const StopServiceStatus& service : stops->status(robot.name).services)
        EXPECT_EQ(service.stage, StopServiceStatus::Stage::Stopped) << service.title;
    ASSERT_TRUE(stops->release(robot.name).ok());
    EXPECT_TRUE(other.until([&] { return other.isTurning(); })) << "it may drive again";
}

TEST(StockRobots, ItObeysWhoeverDrivesItAndStopsHalfASecondAfterTheLastCommand) {
    const TestDomain domain;
    const RobotProcess robot(domain, "stock", {"turtlebot4"});
    const auto node = nodeIn(domain);
    const RobotDescription described = shippedRobot("turtlebot4");
    Driver driver(*node, described);
    ASSERT_TRUE(driver.isConnected());
    EXPECT_TRUE(driver.until([&] { return driver.isTurning(); }));
    const auto newest = [&] { return driver.newest().header.stamp; };
    const Time lastCommand = newest();
    EXPECT_TRUE(waitUntil([&] { return !driver.isTurning(); }, 5s)) << "nobody commands any more";
    const double after = toSeconds(newest() - lastCommand);  // by the robot's own stamps
    std::printf("stands %.2f s after the last command\n", after);
    EXPECT_GT(after, 0.25);
    EXPECT_LT(after, 1.5);
}

}  // namespace
}  // namespace leitstand::test
