#include "core/mapping/motion/mapping_scanner.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr const char *Lidar = "/rover/lidar", *Camera = "/rover/camera/points", *Laser = "/rover/scan";
constexpr Time Began{std::chrono::seconds(1'000)};

RobotDescription rover(bool cameraMaps = false) {
    RobotDescription robot;
    robot.name = "rover";
    for (const char* topic : {Camera, Lidar}) {
        StreamDescription stream;
        stream.role = StreamRole::Points;
        stream.topic = topic;
        stream.maps = cameraMaps && topic == Camera;
        robot.streams.push_back(stream);
    }
    return robot;
}

/// Points on a wall @p range away, in @p degrees about straight ahead.
CloudSample wall(double range, int degrees) {
    CloudSample cloud;
    for (int i = -degrees / 2; i < degrees / 2; ++i) {
        const double direction = i * std::numbers::pi / 180.0;
        cloud.points.emplace_back(range * std::cos(direction), range * std::sin(direction), 0.0);
    }
    cloud.points.emplace_back(std::nanf(""), 0.0F, 0.0F);  // no echo
    return cloud;
}

/// What two scanners send: every @p step one cloud each, for ten seconds.
class Both {
public:
    CloudSample lidar = wall(8.0, 360), camera = wall(4.0, 90);
    std::chrono::milliseconds lidarStep = 100ms, cameraStep = 30ms;

    /// Returns the topic that makes the map in the end.
    std::string chosenBy(MappingScanner& scanner) {
        for (auto after = 0ms; after < 10s; after += 10ms) {
            if (after % lidarStep == 0ms) take(scanner, Lidar, lidar, after);
            if (after % cameraStep == 0ms) take(scanner, Camera, camera, after);
        }
        return scanner.chosen();
    }
    int lidarTaken = 0, cameraTaken = 0;
    std::chrono::milliseconds firstTaken = 10s;

private:
    void take(MappingScanner& scanner, const char* topic, const CloudSample& cloud,
              std::chrono::milliseconds after) {
        if (!scanner.takes(topic, cloud, Began + after)) return;
        firstTaken = std::min(firstTaken, after);
        ++(topic == std::string(Lidar) ? lidarTaken : cameraTaken);
    }
};

std::string chosenOf(Both both) {
    MappingScanner scanner(rover());
    return both.chosenBy(scanner);
}

/// A robot with the cloud @p cloud, and a plane laser.
RobotDescription withPlaneLaser(const char* cloud, bool odometry = true) {
    RobotDescription robot = rover();
    robot.streams.front().topic = cloud;
    robot.streams.back().topic = Laser;
    robot.streams.back().role = StreamRole::Ranges;
    if (odometry) robot.streams.emplace_back().role = StreamRole::Odometry;
    return robot;
}

/// Points on walls 6 m away, @p degrees wide about straight ahead and so high.
CloudSample field(int degrees, int up) {
    CloudSample cloud;
    for (int i = -degrees / 2; i < degrees / 2; ++i) {
        for (int j = -up / 2; j < up / 2; ++j) {
            const double turn = i * std::numbers::pi / 180.0, rise = j * std::numbers::pi / 180.0;
            cloud.points.emplace_back(6.0 * std::cos(turn) * std::cos(rise),
                                      6.0 * std::sin(turn) * std::cos(rise), 6.0 * std::sin(rise));
        }
    }
    return cloud;
}

/// Who makes the map of @p robot when @p cloud comes on @p topic, and turns of a plane laser beside.
std::string besideALaser(const RobotDescription& robot, const char* topic, const CloudSample& cloud) {
    MappingScanner scanner(robot);
    for (auto after = 0ms; after < 10s; after += 100ms) {
        (void)scanner.takes(topic, cloud, Began + after);
        if (scanner.compares(Laser)) (void)scanner.takes(Laser, wall(6.0, 360), Began + after);
    }
    return scanner.chosen();
}

TEST(MappingScanner, APlaneLaserThatSeesMoreThanADepthCameraMakesTheMap) {
    EXPECT_EQ(besideALaser(withPlaneLaser(Camera), Camera, field(70, 50)), Laser);
}

TEST(MappingScanner, A3DScannerMakesTheMapBesideAPlaneLaser) {
    EXPECT_EQ(besideALaser(withPlaneLaser(Lidar), Lidar, field(360, 40)), Lidar);
}

TEST(MappingScanner, AScannerThatStopsForEachScanMakesTheMapBesideAPlaneLaser) {
    MappingScanner scanner(withPlaneLaser(Lidar));
    for (auto after = 0ms; after < 10s; after += 100ms) {
        if (after % 2'500ms == 0ms) (void)scanner.takes(Lidar, field(360, 60), Began + after);
        (void)scanner.takes(Laser, wall(6.0, 360), Began + after);
    }
    EXPECT_EQ(scanner.chosen(), Lidar);
}

TEST(MappingScanner, APlaneLaserIsComparedOnlyWithCloudsThatCome) {
    MappingScanner scanner(withPlaneLaser(Lidar));
    for (auto after = 0ms; after < 60s; after += 100ms)
        EXPECT_FALSE(scanner.takes(Laser, wall(6.0, 360), Began + after));
    EXPECT_EQ(scanner.chosen(), "") << "its robot is not said to map by it";
    MappingScanner silent(withPlaneLaser(Lidar));
    auto after = 0ms;
    while (after < 10s && !silent.takes(Lidar, field(360, 40), Began + after)) after += 100ms;
    EXPECT_EQ(after, 3s) << "a laser that is silent is not waited for";
}

TEST(MappingScanner, WithoutOdometryAPlaneLaserIsNotCompared) {
    EXPECT_EQ(besideALaser(withPlaneLaser(Camera, false), Camera, field(70, 50)), Camera);
}

TEST(MappingScanner, TheOneThatSeesAllAroundMakesTheMapAndTheOtherNever) {
    MappingScanner scanner(rover());
    Both both;
    EXPECT_EQ(both.chosenBy(scanner), Lidar);
    EXPECT_EQ(both.cameraTaken, 0);
    EXPECT_GE(both.firstTaken, 3s) << "they are compared first";
    EXPECT_LE(both.firstTaken, 3100ms);
    EXPECT_GT(both.lidarTaken, 60);
}

TEST(MappingScanner, OfTwoThatLookTheSameWayTheOneThatSeesFartherDoes) {
    Both both;
    both.lidar = wall(20.0, 90);
    EXPECT_EQ(chosenOf(both), Lidar);
    both.camera = wall(25.0, 90);
    EXPECT_EQ(chosenOf(both), Camera);
    both.lidar = wall(90.0, 90);
    both.camera = wall(60.0, 90);
    EXPECT_EQ(chosenOf(both), Camera) << "so far off it makes no difference: the first of the file";
}

TEST(MappingScanner, OneThatComesRarelyCountsLess) {
    Both both;
    both.lidarStep = 2500ms;
    EXPECT_EQ(chosenOf(both), Camera);
}

TEST(MappingScanner, OneThatSendsNothingOrSeesNothingDoesNotMap) {
    Both both;
    both.lidar.points.clear();
    EXPECT_EQ(chosenOf(both), Camera);
    both.lidar = wall(0.2, 360);  // the robot itself
    EXPECT_EQ(chosenOf(both), Camera);
}

TEST(MappingScanner, OneThatStartsLateIsWaitedFor) {
    MappingScanner scanner(rover());
    Both both;
    for (auto after = 0ms; after < 10s; after += 30ms)
        EXPECT_FALSE(scanner.takes(Camera, both.camera, Began - 10s + after)) << "the other may come";
    EXPECT_EQ(both.chosenBy(scanner), Lidar);
    MappingScanner alone(rover());
    both.lidarStep = 1h;
    both.lidar.points.clear();
    for (auto after = 0ms; after < 16s; after += 30ms) (void)alone.takes(Camera, both.camera, Began + after);
    EXPECT_EQ(alone.chosen(), Camera) << "not for ever";
}

TEST(MappingScanner, WhichWayAFrameLooksDoesNotMatter) {
    Both both;
    for (Eigen::Vector3f& point : both.camera.points) point = {-point.y(), -point.z(), point.x()};  // optical
    both.camera.points.resize(90);
    both.lidar = wall(4.5, 360);
    EXPECT_EQ(chosenOf(both), Lidar) << "z ahead is not all around";
}

TEST(MappingScanner, TheFileAndTheOperatorGoBeforeWhatIsMeasured) {
    MappingScanner scanner(rover(true));
    Both both;
    EXPECT_EQ(both.chosenBy(scanner), Camera);
    EXPECT_EQ(both.firstTaken, 0ms) << "nothing is compared";
    scanner.choose(Lidar);
    Both later;
    EXPECT_EQ(later.chosenBy(scanner), Lidar);
    EXPECT_EQ(later.cameraTaken, 0);
}

TEST(MappingScanner, AnOnlyScannerMapsFromItsFirstCloudOn) {
    RobotDescription robot = rover();
    robot.streams.pop_back();
    MappingScanner scanner(robot);
    EXPECT_FALSE(scanner.hasChoice());
    EXPECT_EQ(scanner.chosen(), Camera);
    EXPECT_TRUE(scanner.takes(Camera, wall(4.0, 90), Began));
    EXPECT_TRUE(rover().streams.size() == 2 && MappingScanner(rover()).hasChoice());
}

TEST(MappingScanner, AShortRecordingIsDecidedWithWhatThereIs) {
    MappingScanner scanner(rover());
    EXPECT_FALSE(scanner.takes(Camera, wall(4.0, 90), Began));
    EXPECT_FALSE(scanner.takes(Lidar, wall(8.0, 360), Began + 100ms));
    scanner.decide(Began + 200ms);
    EXPECT_EQ(scanner.chosen(), Lidar);
    MappingScanner silent(rover());
    silent.decide(Began);
    EXPECT_EQ(silent.chosen(), "") << "nothing came at all";
}

}  // namespace
}  // namespace leitstand::test
