#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/io/robot/robot_file.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "robots/simulation/sensors/camera/camera_model.h"
#include "robots/simulation/sensors/sensor_place.h"
#include "robots/simulation/simulated_hardware.h"
#include "tests/simulation/sensors/room.h"
#include "tests/support/places.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

/// Kurt3D looks at the Crawler, which looks back, or stands behind Kurt3D's back when it is @p away.
struct Pair {
    std::unique_ptr<World> world;
    int kurt3d = 0, crawler = 0;
    std::unique_ptr<RobotHardware> ofKurt3d, ofCrawler;
    std::map<std::string, PictureSample> pictures;  ///< by sensor
    std::vector<Eigen::Vector3d> points;            ///< of Kurt3D's scanner, arena's frame
    std::vector<Eigen::Vector3d> ranges;            ///< of the Crawler's laser, arena's frame

    explicit Pair(bool away, bool cameras = true) {
        RoomBuilder room;
        room.walls(3, 2, 1.2);
        world = room.world();
        const auto describe = [](const std::string& name) {
            return readRobot(leitstand::test::sourceFolder() + "/resources/robots/" + name + ".yaml").value();
        };
        kurt3d = world->addRobot(kurt3dBody(), Pose::Identity());
        crawler = world->addRobot(crawlerBody(), away ? poseFrom({-2.4, 0, 0}, 0, 0, degrees(180))
                                                      : poseFrom({1.2, 0, 0}, 0, 0, degrees(180)));
        ofKurt3d = makeKurt3dHardware(*world, kurt3d, describe("kurt3d"), {.cameras = cameras});
        ofCrawler = makeCrawlerHardware(*world, crawler, describe("crawler"), {.cameras = cameras});
        // Down to what is low.
        for (const char* unit : {"left", "right"}) ofKurt3d->setPanTilt(unit, 0.0, degrees(12));
    }
    void run(std::chrono::nanoseconds time) {
        for (const Time end = world->now() + time; world->now() < end;) {
            world->advance(10ms);
            for (HardwareSample& sample : ofKurt3d->take()) take(sample, kurt3d);
            for (HardwareSample& sample : ofCrawler->take()) take(sample, crawler);
        }
    }
    void take(HardwareSample& sample, int robot) {
        if (const auto* picture = sample.sample.as<PictureSample>()) {
            pictures[sample.sensor] = *picture;
        } else if (const auto* cloud = sample.sample.as<CloudSample>()) {
            const Pose mount = poseFrom({0, 0, 0.48}, 0, 0, 0);
            for (std::size_t i = 0; i < cloud->points.size(); ++i) {
                const Time shot = cloud->header.stamp + std::chrono::nanoseconds(cloud->times[i]);
                if (cloud->points[i].allFinite())
                    points.push_back(world->baseInArena(robot, shot) * mount *
                                     cloud->points[i].cast<double>());
            }
        } else if (const auto* scan = sample.sample.as<RangesSample>()) {
            const Pose mount = poseFrom({0.14, 0, 0.20}, 0, 0, 0);
            for (std::size_t i = 0; i < scan->ranges.size(); ++i) {
                const double angle = scan->angleMin + scan->angleStep * double(i),
                             range = double{scan->ranges[i]};
                if (!std::isfinite(range)) continue;
                ranges.push_back(world->baseInArena(robot, scan->header.stamp) * mount *
                                 Eigen::Vector3d(range * std::cos(angle), range * std::sin(angle), 0.0));
            }
        }
    }
    /// How many of @p seen lie on @p robot where it truly is, and not on what is below it.
    [[nodiscard]] int on(int robot, const std::vector<Eigen::Vector3d>& seen) const {
        const BodySpec& spec = world->spec(robot);
        const Pose toBase = world->state(robot).baseInArena.inverse();
        return int(std::count_if(seen.begin(), seen.end(), [&](const Eigen::Vector3d& point) {
            const Eigen::Vector3d p = toBase * point;
            return std::abs(p.x()) < spec.outline[0].x() + 0.04 && std::abs(p.y()) < 0.20 && p.z() > 0.05 &&
                   p.z() < spec.bumpTo + 0.04;
        }));
    }
};

/// Mean of a number of each pixel in the rectangle that @p robot takes in a picture.
double meanOf(const Pair& pair, int robot, const CameraModel& model, const Pose& cameraInArena,
              const std::function<double(int x, int y)>& value) {
    const BodySpec& spec = pair.world->spec(robot);
    Eigen::Vector2d least(1e9, 1e9), most(-1e9, -1e9);
    for (const Eigen::Vector2d& corner : spec.outline) {
        for (const double height : {0.05, std::min(0.20, spec.bumpTo)}) {
            const Eigen::Vector3d at = pair.world->state(robot).baseInArena *
                                       Eigen::Vector3d(0.9 * corner.x(), 0.7 * corner.y(), height);
            const auto pixel = model.project(cameraInArena.inverse() * at);
            if (!pixel) continue;
            least = least.cwiseMin(*pixel);
            most = most.cwiseMax(*pixel);
        }
    }
    double sum = 0.0;
    int count = 0;
    for (int y = std::max(0, int(least.y())); y <= std::min(model.height - 1, int(most.y())); ++y) {
        for (int x = std::max(0, int(least.x())); x <= std::min(model.width - 1, int(most.x()));
             ++x, ++count) {
            sum += value(x, y);
        }
    }
    EXPECT_GT(count, 30);
    return sum / std::max(1, count);
}

double channel(const Picture& picture, int x, int y, int which) {
    return double(std::to_integer<int>(picture.bytes[std::size_t(3 * (picture.width * y + x) + which)]));
}

TEST(BothRobots, SeeEachOtherWithTheirLasersWhereTheyTrulyAre) {
    Pair pair(false, false), alone(true, false);
    for (Pair* one : {&pair, &alone}) one->run(2400ms);
    EXPECT_GT(pair.on(pair.crawler, pair.points), 100);
    EXPECT_GT(pair.on(pair.kurt3d, pair.ranges), 24 * 15) << "24 turns";
    // Where the Crawler was there is nothing when it is away.
    const auto there = [](const std::vector<Eigen::Vector3d>& points) {
        return std::count_if(points.begin(), points.end(), [](const Eigen::Vector3d& p) {
            return std::abs(p.x() - 1.2) < 0.25 && std::abs(p.y()) < 0.2 && p.z() > 0.05 && p.z() < 0.4;
        });
    };
    EXPECT_GT(there(pair.points), 100);
    EXPECT_EQ(there(alone.points), 0);
    // It drives away: each sees the other at its new place.
    pair.ofCrawler->setMotors(-0.6, -0.6);
    pair.run(1s);
    pair.ofCrawler->setMotors(0, 0);
    pair.world->setBrake(pair.crawler, true);
    pair.run(500ms);
    pair.points.clear();
    pair.ranges.clear();
    pair.run(2400ms);
    EXPECT_GT(pair.world->state(pair.crawler).baseInArena.translation().x(), 1.5);
    EXPECT_GT(pair.on(pair.crawler, pair.points), 25) << "farther away";
    EXPECT_GT(pair.on(pair.kurt3d, pair.ranges), 24 * 10);
}

TEST(BothRobots, SeeEachOtherInTheirPictures) {
    Pair pair(false), alone(true);
    for (Pair* one : {&pair, &alone}) one->run(500ms);
    const Pose kurt3d = pair.world->state(pair.kurt3d).baseInArena;
    const auto onUnit = [&](double y, double z) {  // axes 3 cm behind the camera, tilted down by 12 degrees
        Pose axes = poseFrom({0.16, y, z}, 0, degrees(12), 0);
        return Pose(kurt3d * axes * opticalAt(0.03, 0, 0));
    };
    const auto yellow = [&](const Pair& in, const std::string& sensor, double y) {
        const auto picture = decodePicture(in.pictures.at(sensor));
        EXPECT_TRUE(picture);
        return meanOf(pair, pair.crawler, pinholeCamera(), onUnit(y, 0.33),
                      [&](int u, int v) { return channel(*picture, u, v, 0) - channel(*picture, u, v, 2); });
    };
    const double left = yellow(pair, "left", 0.08), leftAlone = yellow(alone, "left", 0.08);
    const double right = yellow(pair, "right", -0.08), rightAlone = yellow(alone, "right", -0.08);
    EXPECT_GT(left, leftAlone + 15) << "the Crawler is yellow";
    EXPECT_GT(right, rightAlone + 15);

    const auto warmth = [&](const Pair& in) {
        const auto picture = decodePicture(in.pictures.at("ir"));
        EXPECT_TRUE(picture);
        const auto thermal = temperatures(*picture, {});
        EXPECT_TRUE(thermal);
        return meanOf(pair, pair.crawler, infraredOptics(), onUnit(-0.08, 0.36),
                      [&](int u, int v) { return double{thermal->celsius[std::size_t(160 * v + u)]}; });
    };
    const double warm = warmth(pair), cold = warmth(alone);
    EXPECT_GT(warm, cold + 0.8) << "its motors";

    const Pose crawler = pair.world->state(pair.crawler).baseInArena;
    Pose mirror = Pose::Identity();
    mirror.linear() = mirrorAxes();
    mirror.translation().z() = 0.34;
    const auto red = [&](const Pair& in) {
        const auto picture = decodePicture(in.pictures.at("omni"));
        EXPECT_TRUE(picture);
        return meanOf(pair, pair.kurt3d, omnidirectionalCamera(), crawler * mirror,
                      [&](int u, int v) { return channel(*picture, u, v, 0) - channel(*picture, u, v, 1); });
    };
    const double seen = red(pair), notSeen = red(alone);
    EXPECT_GT(seen, notSeen + 8) << "Kurt3D is red";
    std::printf(
        "the Crawler: yellow by %.0f and %.0f (%.0f, %.0f without it), %.1f degrees (%.1f); "
        "Kurt3D: red by %.0f (%.0f)\n",
        left, right, leftAlone, rightAlone, warm, cold, seen, notSeen);
}

}  // namespace
}  // namespace leitstand::simulation::test
