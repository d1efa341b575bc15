#include "app/services/places/sensor_poses.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/services/places/frame_tracks.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

const Pose Said = poseFrom({0.1, 0.0, 0.5}, 0, 0, 0);

RobotDescription robotWithScanner() {
    RobotDescription robot;
    robot.name = "rover";
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.sensors["scanner"].frame = "lidar";
    robot.sensors["scanner"].sensorInBase = Said;
    robot.sensors["scanner"].correction = {-0.02, 0.0, degrees(1)};
    return robot;
}

Event mountByTransforms() {
    TransformsSample sample;
    FrameTransform one;
    one.header.frame = "base_link";
    one.childFrame = "lidar";
    one.childInParent = Said;
    sample.transforms.push_back(one);
    Event event;
    event.role = StreamRole::StaticTransforms;
    event.sample = sample;
    return event;
}

double pitchOf(const Pose& pose) {
    return std::asin(-(pose.linear() * Eigen::Vector3d::UnitX()).z());
}

TEST(SensorPoses, APlaceIsKnownByTheFileByTransformsOrBecauseItIsTheBase) {
    RobotDescription robot = robotWithScanner();
    EXPECT_TRUE(SensorPoses(robot).isPlaced("scanner", "lidar"));
    EXPECT_TRUE(SensorPoses(robot).isPlaced("", "rover/lidar"));
    robot.sensors.clear();
    SensorPoses poses(robot);
    EXPECT_FALSE(poses.isPlaced("scanner", "lidar"));
    EXPECT_TRUE(poses.isPlaced("scanner", "base_link"));
    EXPECT_TRUE(poses.isPlaced("", "odom"));
    poses.add(mountByTransforms());
    EXPECT_TRUE(poses.isPlaced("scanner", "lidar"));
}

TEST(SensorPoses, ALeanIsInTheMountWhoeverTellsOfIt) {
    const RobotDescription robot = robotWithScanner();
    SensorPoses byFile(robot), byTransforms(robot);
    byTransforms.add(mountByTransforms());
    FrameTracks tracks(robot);
    tracks.add(mountByTransforms());
    const auto tracked = tracks.inBase("scanner", "rover/lidar", Time{});
    ASSERT_TRUE(tracked.has_value());
    for (const Pose& pose : {byFile.inBase("scanner", "rover/lidar"), byFile.inBase("", "lidar"),
                             byTransforms.inBase("scanner", "lidar"), *tracked}) {
        EXPECT_NEAR(pitchOf(pose), degrees(1), 1e-9);
        EXPECT_EQ(pose.translation(), Said.translation());
    }
    EXPECT_EQ(byFile.correctionOf("scanner", "lidar").range, -0.02);
}

TEST(SensorPoses, ACorrectionThatIsSetTakesTheFilesPlace) {
    const RobotDescription robot = robotWithScanner();
    SensorPoses poses(robot);
    poses.setCorrection("scanner", "scanner", {0.01, 0.0, 0.0});
    EXPECT_EQ(poses.correctionOf("", "lidar").range, 0.01);
    EXPECT_NEAR(pitchOf(poses.inBase("scanner", "lidar")), 0.0, 1e-9);
}

TEST(SensorPoses, WhatComesInTheBasesOrTheOdometrysFrameIsNotCorrected) {
    const RobotDescription robot = robotWithScanner();
    const SensorPoses poses(robot);
    for (const char* frame : {"base_link", "rover/odom"}) {
        EXPECT_FALSE(poses.isOfScanner(frame));
        EXPECT_TRUE(poses.correctionOf("scanner", frame).isNone()) << frame;
    }
}

}  // namespace
}  // namespace leitstand::test
