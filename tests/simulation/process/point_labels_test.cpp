#include "robots/simulation/process/point_labels.h"

#include <array>

#include <gtest/gtest.h>

#include "core/cloud/scan.h"
#include "core/io/robot/robot_file.h"
#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/simulated_hardware.h"
#include "tests/support/places.h"

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

constexpr const char* Hall = R"(
name: hall
from: [-2.5, -2]
to: [2.5, 2]
elements:
  - {kind: floor, position: [0, 0, 0], size: [5, 4, 0.1]}
  - {kind: wall, position: [0, 2, 0], size: [5, 0.05, 1.2]}
  - {kind: wall, position: [0, -2, 0], size: [5, 0.05, 1.2]}
  - {kind: wall, position: [2.5, 0, 0], turn: [0, 0, 90], size: [4, 0.05, 1.2]}
  - {kind: wall, position: [-2.5, 0, 0], turn: [0, 0, 90], size: [4, 0.05, 1.2]}
  - {kind: ceiling, position: [-1.5, 0, 1.1], size: [1.6, 3.9, 0.02]}
  - {kind: table, position: [1.5, 1.2, 0]}
)";

const Eigen::Vector3d Other(0.8, 0.0, 0.2);  ///< middle of the other robot

struct Count {
    int of = 0, right = 0;
    void add(std::uint8_t found, Label expected) {
        ++of;
        right += found == static_cast<std::uint8_t>(expected) ? 1 : 0;
    }
    [[nodiscard]] double share() const { return of == 0 ? 0.0 : double(right) / of; }
};

/// By where a point is in the arena, far from every edge.
struct Places {
    Count floor, wall, ceiling, robot, missing;
    void add(const Eigen::Vector3d& at, const Eigen::Vector3d& kurt3d, std::uint8_t label) {
        const double x = std::abs(at.x()), y = std::abs(at.y());
        const bool inside = x < 2.3 && y < 1.8;
        const bool furnished = at.x() > 0.8 && at.y() > 0.5;
        const bool beside = (at - kurt3d).head<2>().norm() < 0.45 || (at - Other).head<2>().norm() < 0.4;
        if (inside && !furnished && !beside && std::abs(at.z()) < 0.04) floor.add(label, Label::Floor);
        const bool atWall = (std::abs(x - 2.5) < 0.05 && y < 1.8) || (std::abs(y - 2.0) < 0.05 && x < 2.3);
        if (atWall && at.z() > 0.2 && at.z() < 0.9) wall.add(label, Label::Wall);
        if (at.x() > -2.2 && at.x() < -0.8 && y < 1.8 && std::abs(at.z() - 1.1) < 0.04)
            ceiling.add(label, Label::Ceiling);
        if ((at - Other).norm() < 0.25 && at.z() > 0.06) robot.add(label, Label::Unlabelled);
    }
};

TEST(PointLabels, ArePerfectAlsoWhileTheRobotDrives) {
    World world(parseArena(Hall, "hall").value(), 3);
    const auto description =
        readRobot(leitstand::test::sourceFolder() + "/resources/robots/kurt3d.yaml").value();
    const int kurt3d = world.addRobot(kurt3dBody(), poseFrom({-0.8, 0, 0}, 0, 0, 0));
    const int other = world.addGhost(crawlerBody());
    world.placeGhost(other, poseFrom({0.8, 0, 0}, 0, 0, 0));
    HardwareSettings settings;
    settings.cameras = false;
    const auto hardware = makeKurt3dHardware(world, kurt3d, description, settings);
    hardware->setBrake(false);
    hardware->setMotors(0.4, 0.6);
    const PointLabels labels(description, kurt3d);
    Places places;
    int points = 0;
    while (world.seconds() < 2.5) {
        world.advance(5ms);
        for (const HardwareSample& sample : hardware->take()) {
            const auto* cloud = sample.sample.as<CloudSample>();
            if (cloud == nullptr) continue;
            const PictureSample picture = labels.of(*cloud, world);
            ASSERT_EQ(picture.encoding, "mono8");
            ASSERT_EQ(picture.height, cloud->rows);
            ASSERT_EQ(picture.width, cloud->columns);
            ASSERT_EQ(picture.header.stamp, cloud->header.stamp);
            ASSERT_EQ(picture.header.frame, cloud->header.frame);
            ASSERT_EQ(picture.content.bytes.size(), cloud->points.size());
            const Pose mount = description.sensors.at("scanner").sensorInBase;
            for (std::size_t i = 0; i < cloud->points.size(); ++i) {
                const auto label = std::to_integer<std::uint8_t>(picture.content.bytes[i]);
                if (!cloud->points[i].allFinite()) {
                    places.missing.add(label, Label::Unlabelled);
                    continue;
                }
                ++points;
                const Time shot = cloud->header.stamp + std::chrono::nanoseconds(cloud->times[i]);
                const Pose base = world.baseInArena(kurt3d, shot);
                places.add(base * mount * cloud->points[i].cast<double>(), base.translation(), label);
            }
        }
    }
    EXPECT_GT((world.state(kurt3d).baseInArena.translation() - Eigen::Vector3d(-0.8, 0, 0)).norm(), 0.3);
    EXPECT_GT(points, 15'000);
    EXPECT_GT(places.floor.of, 1'000);
    EXPECT_GT(places.wall.of, 1'000);
    EXPECT_GT(places.ceiling.of, 500);
    EXPECT_GT(places.robot.of, 20);
    EXPECT_GT(places.floor.share(), 0.995);
    EXPECT_GT(places.wall.share(), 0.995);
    EXPECT_GT(places.ceiling.share(), 0.995);
    EXPECT_GT(places.robot.share(), 0.9);
    EXPECT_EQ(places.missing.right, places.missing.of);
}

TEST(PointLabels, APointWhereNothingStandsHasNone) {
    World world(parseArena(Hall, "hall").value(), 3);
    const auto description =
        readRobot(leitstand::test::sourceFolder() + "/resources/robots/kurt3d.yaml").value();
    const int kurt3d = world.addRobot(kurt3dBody(), poseFrom({0, 0, 0}, 0, 0, 0));
    world.advance(5ms);
    const Eigen::Vector3d laser = description.sensors.at("scanner").sensorInBase.translation();
    const auto z = static_cast<float>(laser.z());
    CloudSample cloud;
    cloud.header.stamp = world.now();
    cloud.points = {{2.48F, 0.0F, 0.0F}, {1.5F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.8F, -0.5F, -z}};
    const PictureSample picture = PointLabels(description, kurt3d).of(cloud, world);
    EXPECT_EQ(picture.height, 1);
    EXPECT_EQ(picture.width, 4);
    const auto at = [&](std::size_t i) { return static_cast<Label>(picture.content.bytes[i]); };
    EXPECT_EQ(at(0), Label::Wall);
    EXPECT_EQ(at(1), Label::Unlabelled) << "in the air";
    EXPECT_EQ(at(2), Label::Unlabelled) << "half a metre before the wall";
    EXPECT_EQ(at(3), Label::Floor);
}

}  // namespace
}  // namespace leitstand::simulation::test
