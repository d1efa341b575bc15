#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "robots/simulation/simulated_hardware.h"
#include "tests/simulation/sensors/room.h"
#include "tests/support/places.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

/// Of points against the walls and the floor that they must lie on.
struct Misses {
    int points = 0, far = 0;  ///< far: more than three deviations off
    double squares = 0.0;     ///< in deviations

    void add(const Eigen::Vector3d& inArena, double range) {
        const double off = std::min({std::abs(std::abs(inArena.x()) - 2.0),
                                     std::abs(std::abs(inArena.y()) - 1.6), std::abs(inArena.z())}) /
                           (0.005 + 0.01 * range);
        ++points;
        far += off > 3.0 ? 1 : 0;
        squares += off * off;
    }
};

/// The Crawler with its turning unit drives a curve in a room; what it says alone tells where points are,
/// but for its own place, which is the true one.
TEST(TurningUrg, ItsSlicesAndFansLieOnTheTrueWallsWhileItDrives) {
    RoomBuilder room;
    room.walls(2.0, 1.6, 0.8);
    const auto world = room.world();
    const auto description =
        readRobot(leitstand::test::sourceFolder() + "/resources/robots/crawler.yaml").value();
    BodySpec body = crawlerBody();
    body.shape = {};  // what it carries sees only the room
    const int robot = world->addRobot(body, poseFrom({-1.0, -0.6, 0}, 0, 0, 0.2));
    const auto hardware =
        makeCrawlerHardware(*world, robot, description, {.turningLaser = true, .cameras = false});
    hardware->setMotors(0.05, 0.62);  // skids, or it goes straight on
    std::map<std::string, Pose> inBase;
    std::map<Time, Pose> fans;
    Misses slices, ranges;
    std::set<int> rings;
    int clouds = 0;
    for (int step = 0; step < 650; ++step) {
        world->advance(10ms);
        for (const HardwareSample& sample : hardware->take()) {
            if (const auto* tf = sample.sample.as<TransformsSample>()) {
                for (const FrameTransform& one : tf->transforms) {
                    if (sample.role == StreamRole::StaticTransforms)
                        inBase[one.childFrame] = one.childInParent;
                    if (one.childFrame == "laser_fan") fans[one.header.stamp] = one.childInParent;
                }
            } else if (const auto* cloud = sample.sample.as<CloudSample>()) {
                ++clouds;
                ASSERT_EQ(cloud->header.frame, "laser");
                ASSERT_TRUE(inBase.contains("laser"));
                for (std::size_t i = 0; i < cloud->points.size(); ++i) {
                    rings.insert(cloud->rings[i]);
                    if (!cloud->points[i].allFinite()) continue;
                    const Time shot = cloud->header.stamp + std::chrono::nanoseconds(cloud->times[i]);
                    const Eigen::Vector3d point = cloud->points[i].cast<double>();
                    slices.add(world->baseInArena(robot, shot) * inBase["laser"] * point, point.norm());
                }
            } else if (const auto* fan = sample.sample.as<RangesSample>()) {
                ASSERT_TRUE(fans.contains(fan->header.stamp)) << "tf tells how it stood";
                for (std::size_t i = 0; i < fan->ranges.size(); ++i) {
                    const double range = double{fan->ranges[i]};
                    if (!std::isfinite(range)) continue;
                    const double angle = fan->angleMin + fan->angleStep * double(i);
                    const Time shot = fan->header.stamp +
                                      std::chrono::nanoseconds(std::llround(1e9 * fan->timeStep * double(i)));
                    ranges.add(world->baseInArena(robot, shot) * inBase["laser"] * fans[fan->header.stamp] *
                                   Eigen::Vector3d(range * std::cos(angle), range * std::sin(angle), 0.0),
                               range);
                }
            }
        }
    }
    EXPECT_NEAR(clouds, 12, 1) << "two a second";
    EXPECT_EQ(rings.size(), 61U) << "a turn of 6 s; the last repeats the first";
    for (const Misses& misses : {slices, ranges}) {
        EXPECT_GT(misses.points, 12'000);
        EXPECT_LT(double(misses.far), 0.01 * misses.points) << "and edges";
        EXPECT_LT(std::sqrt(misses.squares / misses.points), 1.1);
        std::printf("%d points, %d farther than three deviations off the walls\n", misses.points, misses.far);
    }
    EXPECT_GT(angleBetween(world->state(robot).baseInArena, poseFrom({0, 0, 0}, 0, 0, 0.2)), degrees(20))
        << "it turned meanwhile";
}

}  // namespace
}  // namespace leitstand::simulation::test
