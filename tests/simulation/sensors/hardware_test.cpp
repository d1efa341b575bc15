#include "robots/simulation/simulated_hardware.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "robots/simulation/simulated_robot.h"
#include "tests/simulation/sensors/room.h"
#include "tests/support/places.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;
using Key = std::pair<StreamRole, std::string>;

RobotDescription shipped(const std::string& name) {
    auto robot = readRobot(leitstand::test::sourceFolder() + "/resources/robots/" + name + ".yaml");
    EXPECT_TRUE(robot) << robot.error().text;
    return std::move(robot).value();
}

std::unique_ptr<World> roomWorld() {
    RoomBuilder room;
    room.walls(4, 3, 2);
    room.box(room.surface(Material::Skin, Label::Wall, 34.0), {2, 0.1, 0.0}, {2.1, 0.5, 0.4});
    room.victim({2.0, 0.3, 0.3}, 4000.0);
    return room.world();
}

std::vector<HardwareSample> drive(World& world, RobotHardware& hardware, std::chrono::nanoseconds time,
                                  std::chrono::nanoseconds step = 20ms) {
    std::vector<HardwareSample> all;
    for (const Time end = world.now() + time; world.now() < end;) {
        world.advance(step);
        for (HardwareSample& sample : hardware.take()) all.push_back(std::move(sample));
    }
    return all;
}

struct Robot {
    RobotDescription description;
    std::unique_ptr<World> world = roomWorld();
    std::unique_ptr<RobotHardware> hardware;
};

Robot kurt3d(const HardwareSettings& settings = {}) {
    Robot robot{shipped("kurt3d"), roomWorld(), {}};
    const int number = robot.world->addRobot(kurt3dBody(), Pose::Identity());
    robot.hardware = makeKurt3dHardware(*robot.world, number, robot.description, settings);
    return robot;
}

Robot crawler(const HardwareSettings& settings = {}) {
    Robot robot{shipped("crawler"), roomWorld(), {}};
    const int number = robot.world->addRobot(crawlerBody(), Pose::Identity());
    robot.hardware = makeCrawlerHardware(*robot.world, number, robot.description, settings);
    return robot;
}

TEST(Hardware, HoldsTheRatesOfTheDesign) {
    const std::map<Key, double> ofKurt3d = {
        {{StreamRole::Points, "scanner"}, 10}, {{StreamRole::Odometry, ""}, 20},
        {{StreamRole::Imu, "imu"}, 20},        {{StreamRole::Joints, ""}, 20},
        {{StreamRole::Transforms, ""}, 40},    {{StreamRole::Picture, "left"}, 10},
        {{StreamRole::Picture, "right"}, 10},  {{StreamRole::CameraInfo, "left"}, 10},
        {{StreamRole::Thermal, "ir"}, 9},      {{StreamRole::Gas, "co2"}, 1},
        {{StreamRole::Battery, ""}, 1},        {{StreamRole::Diagnostics, ""}, 1},
    };
    const std::map<Key, double> ofCrawler = {
        {{StreamRole::Ranges, "laser"}, 10}, {{StreamRole::Odometry, ""}, 20},
        {{StreamRole::Imu, "imu"}, 20},      {{StreamRole::Picture, "omni"}, 6},
        {{StreamRole::Battery, ""}, 1},      {{StreamRole::Transforms, ""}, 20},
    };
    for (const bool first : {true, false}) {
        Robot robot = first ? kurt3d() : crawler();
        std::map<Key, int> counts;
        for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 5s)) {
            ++counts[{sample.role, sample.sensor}];
        }
        for (const auto& [key, rate] : first ? ofKurt3d : ofCrawler) {
            EXPECT_NEAR(counts[key], 5 * rate, 2.0) << toString(key.first) << " " << key.second;
        }
        EXPECT_EQ((counts[{StreamRole::StaticTransforms, ""}]), 1);
        EXPECT_EQ((counts[{StreamRole::Bumps, ""}]), 1);
    }
}

TEST(Hardware, DriversOnBoardHaveAllThatLasersMeasureWhateverIsSent) {
    for (const bool first : {true, false}) {
        Robot robot = first ? kurt3d({.cameras = false}) : crawler({.cameras = false});
        const StreamRole role = first ? StreamRole::Points : StreamRole::Ranges;
        const char* const sensor = first ? "scanner" : "laser";
        for (const double rate : {10.0, 2.0, 1.0, 0.0}) {  // 0: none at all
            robot.hardware->setStream(role, sensor, {.enabled = rate > 0.0, .rate = rate});
            int onBoard = 0, sent = 0;
            for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 10s)) {
                if (sample.role != role) continue;
                onBoard += sample.reach != Reach::Sent ? 1 : 0;
                sent += sample.reach != Reach::OnBoard ? 1 : 0;
            }
            EXPECT_NEAR(onBoard, 100, 5) << sensor << " at " << rate << " Hz";
            EXPECT_NEAR(sent, 10.0 * rate, 6.0) << sensor << " at " << rate << " Hz";
        }
    }
}

TEST(Hardware, SendsSamplesThatTheWireTakes) {
    for (int kind = 0; kind < 4; ++kind) {
        Robot robot = kind == 0   ? kurt3d()
                      : kind == 1 ? kurt3d({.scanner = ScannerMount::Tilting})
                      : kind == 2 ? crawler()
                                  : crawler({.turningLaser = true});
        robot.hardware->setPanTilt("left", 0.3, 0.1);
        std::set<StreamRole> roles;
        for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 4200ms)) {
            const StreamDescription* stream = robot.description.stream(sample.role, sample.sensor);
            ASSERT_NE(stream, nullptr) << toString(sample.role) << " " << sample.sensor;
            const auto payload = encode(sample.sample, stream->type);
            ASSERT_TRUE(payload) << toString(sample.role) << ": " << payload.error().text;
            const RawEvent event{1, robot.world->now(), stream->topic, stream->type, *payload};
            const auto decoded = decodeEvent(event, robot.description, *stream);
            ASSERT_TRUE(decoded) << decoded.error().text;
            EXPECT_EQ(decoded->sample.index(), sample.sample.index());
            roles.insert(sample.role);
        }
        EXPECT_GE(roles.size(), robot.description.letter == "K" ? 13U : 9U);
    }
}

TEST(Hardware, KeepsWithinTheBudgetOfTheLink) {
    // docs/design.md, "The wire": bits a second of each stream on a link of 10 Mbit/s
    const std::map<std::string, double> budget = {
        {"scanner", 2.25e6}, {"left", 0.7e6}, {"right", 0.7e6}, {"ir", 1.2e6}, {"omni", 0.6e6}};
    for (const bool first : {true, false}) {
        Robot robot = first ? kurt3d() : crawler();
        std::map<std::string, double> bits;
        double telemetry = 0.0;
        for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 3s)) {
            const StreamDescription* stream = robot.description.stream(sample.role, sample.sensor);
            ASSERT_NE(stream, nullptr);
            const double size = 8.0 * double((*encode(sample.sample, stream->type))->size()) / 3.0;
            (budget.contains(sample.sensor) && sample.role != StreamRole::CameraInfo ? bits[sample.sensor]
                                                                                     : telemetry) += size;
        }
        for (const auto& [sensor, rate] : bits) {
            EXPECT_LT(rate, budget.at(sensor)) << sensor;
            std::printf("%s %.2f Mbit/s\n", sensor.c_str(), rate / 1e6);
        }
        EXPECT_LT(telemetry, 0.6e6);
        std::printf("telemetry %.2f Mbit/s\n", telemetry / 1e6);
    }
}

TEST(Hardware, RepeatsItselfForASeedHoweverOftenItIsAsked) {
    const auto digest = [](std::uint64_t seed, std::chrono::nanoseconds step) {
        Robot robot = kurt3d({.seed = seed, .cameras = false});
        robot.hardware->setMotors(0.4, 0.5);
        double sum = 0.0;
        for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 3s, step)) {
            if (const auto* cloud = sample.sample.as<CloudSample>()) {
                for (const float value : cloud->intensities) sum += double{value};
            } else if (const auto* odometry = sample.sample.as<OdometrySample>()) {
                sum += odometry->baseInOdom.translation().x();
            } else if (const auto* gas = sample.sample.as<GasSample>()) {
                sum += gas->ppm;
            }
        }
        return sum;
    };
    EXPECT_EQ(digest(1, 20ms), digest(1, 20ms));
    EXPECT_NE(digest(1, 20ms), digest(2, 20ms));
}

TEST(Hardware, TurnsItsPanTiltUnitsAndTellsTheirFrames) {
    Robot robot = kurt3d({.cameras = false});
    robot.hardware->setPanTilt("right", degrees(40), degrees(-10));
    robot.hardware->setPanTilt("nobody", 1.0, 1.0);
    std::map<std::string, FrameTransform> frames;
    JointSample joints;
    for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 1s)) {
        if (const auto* transforms = sample.sample.as<TransformsSample>()) {
            for (const FrameTransform& one : transforms->transforms) frames[one.childFrame] = one;
        } else if (const auto* one = sample.sample.as<JointSample>()) {
            joints = *one;
        }
    }
    ASSERT_EQ(joints.names.size(), 6U);
    EXPECT_EQ(joints.names[4], "right_pan");
    EXPECT_NEAR(joints.positions[4], degrees(40), 1e-9);
    EXPECT_NEAR(joints.positions[5], degrees(-10), 1e-9);
    EXPECT_NEAR(joints.positions[2], 0.0, 1e-9);
    for (const char* frame :
         {"laser", "left_camera", "right_camera", "infrared", "co2", "imu", "base_link"}) {
        EXPECT_TRUE(frames.contains(frame)) << frame;
    }
    Pose place = Pose::Identity();
    for (std::string frame = "infrared"; frame != "base_link"; frame = frames.at(frame).header.frame) {
        ASSERT_TRUE(frames.contains(frame)) << frame;
        place = frames.at(frame).childInParent * place;
    }
    const Eigen::Vector3d ahead = place.linear().col(2);
    EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), degrees(40), 1e-6);
    EXPECT_NEAR(std::asin(ahead.z()), degrees(10), 1e-6) << "up";
    EXPECT_EQ(frames.at("base_link").header.frame, "odom");
    EXPECT_TRUE(
        frames.at("left_camera").childInParent.translation().isApprox(Eigen::Vector3d(0.03, 0, 0), 1e-6));
}

TEST(Hardware, DrivesAndSwitchesStreams) {
    Robot robot = kurt3d({.cameras = false});
    robot.hardware->setStream(StreamRole::Points, "scanner", {.enabled = false});
    robot.hardware->setStream(StreamRole::Odometry, "", {.rate = 5.0});
    robot.hardware->setMotors(5.0, std::nan(""));
    int odometry = 0;
    for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 2s)) {
        EXPECT_FALSE(sample.role == StreamRole::Points && sample.reach != Reach::OnBoard);
        odometry += sample.role == StreamRole::Odometry ? 1 : 0;
    }
    EXPECT_NEAR(odometry, 10, 1);
    EXPECT_GT(robot.hardware->tracks().left, 0.1);
    EXPECT_GT(robot.hardware->tracks().leftCurrent, 0.0);
    EXPECT_FALSE(robot.hardware->remote());
    TwistSample remote;
    remote.linear.x() = 0.2;
    dynamic_cast<SimulatedRobot&>(*robot.hardware).setRemote(remote);
    EXPECT_EQ(robot.hardware->remote()->linear.x(), 0.2);
}

TEST(Hardware, SeesItsOwnBodyAndNoneOfItsScannersHead) {
    Robot robot = kurt3d({.cameras = false});
    int own = 0, points = 0;
    for (const HardwareSample& sample : drive(*robot.world, *robot.hardware, 2400ms)) {
        const auto* cloud = sample.sample.as<CloudSample>();
        if (cloud == nullptr) continue;
        for (const Eigen::Vector3f& point : cloud->points) {
            if (!point.allFinite()) continue;
            EXPECT_GT(point.norm(), 0.13F);
            const Eigen::Vector3f inBase = point + Eigen::Vector3f(0, 0, 0.48F);
            own += std::abs(inBase.x()) < 0.24F && std::abs(inBase.y()) < 0.17F && inBase.z() > 0.03F ? 1 : 0;
            ++points;
        }
    }
    EXPECT_GT(own, 500);
    EXPECT_LT(own, points / 4);
}

}  // namespace
}  // namespace leitstand::simulation::test
