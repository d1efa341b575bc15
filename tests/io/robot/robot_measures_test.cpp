// Measures of robots, written into files that people keep.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/rotation/euler_angles.h"
#include "core/io/robot/editing/robot_edits.h"
#include "core/io/robot/robot_file.h"
#include "core/io/settings/folders.h"
#include "tests/io/robot/robot_texts.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string Tail = "streams:\n  - {role: odometry}\n";

RobotMeasures measures() {
    return {{{0.4, 0.2}, {-0.35, 0.2}, {-0.35, -0.21}, {0.4, -0.21}}, 0.625, {}};
}

std::string changed(const std::string& text, const RobotMeasures& wanted) {
    const auto result = withMeasures(text, "r.yaml", wanted);
    EXPECT_TRUE(result) << result.error().text;
    return result ? *result : std::string();
}

void expectMeasures(const std::string& text, const RobotMeasures& wanted) {
    const auto robot = parseRobot(text, "r.yaml");
    ASSERT_TRUE(robot) << robot.error().text << "\n" << text;
    ASSERT_EQ(robot->footprint.size(), wanted.footprint.size());
    for (std::size_t i = 0; i < wanted.footprint.size(); ++i)
        EXPECT_TRUE(robot->footprint[i].isApprox(wanted.footprint[i], 1e-6));
    EXPECT_DOUBLE_EQ(robot->height, wanted.height);
    for (const auto& [name, pose] : wanted.sensorsInBase)
        EXPECT_TRUE(robot->sensors.at(name).sensorInBase.isApprox(pose, 1e-3)) << name << "\n" << text;
}

TEST(RobotMeasures, ReplaceWhatTheFileSaysAndLeaveTheRest) {
    const std::string text = Head +
                             "# measured on Friday\n"
                             "footprint: [[0.3, 0.2], [-0.3, 0.2],  # rear bumper\n"
                             "            [-0.3, -0.2], [0.3, -0.2]]  # 60 x 40 cm\n"
                             "height: 0.5  # with the mast down\n"
                             "sensors:\n"
                             "  lidar: {frame: velodyne, position: [0, 0, 0.4]}  # on the mast\n"
                             "  front:\n"
                             "    frame: front_optical\n"
                             "    rotation: [-90, 0, -90]\n" +
                             Tail;
    RobotMeasures wanted = measures();
    wanted.sensorsInBase["lidar"] = poseFrom({0.05, 0, 0.55}, 0, 0, degrees(90));
    wanted.sensorsInBase["front"] = poseFrom({0.3, 0.01, 0.2}, degrees(-90), 0, degrees(-80));
    const std::string result = changed(text, wanted);
    expectMeasures(result, wanted);
    for (const char* kept : {"# measured on Friday", "# 60 x 40 cm", "# with the mast down", "# on the mast",
                             "frame: front_optical", "frame: velodyne"})
        EXPECT_THAT(result, HasSubstr(kept));
    EXPECT_EQ(changed(result, wanted), result) << "the same again changes nothing";
}

TEST(RobotMeasures, AreAddedWhereTheFileHasNone) {
    RobotMeasures wanted = measures();
    wanted.sensorsInBase["lidar"] = poseFrom({0.05, 0, 0.55}, 0, 0, 0);
    expectMeasures(changed(Head + Tail, wanted), wanted);
    expectMeasures(changed(Head + "sensors: {lidar: {}}\n" + Tail, wanted), wanted);
    expectMeasures(changed(Head + "sensors:\n  camera: {}\n" + Tail, wanted), wanted);
}

TEST(RobotMeasures, ThatMakeNoSenseAreRefusedBeforeAnythingIsWritten) {
    RobotMeasures crossed = measures();
    std::swap(crossed.footprint[1], crossed.footprint[2]);
    EXPECT_THAT(withMeasures(Head + Tail, "r.yaml", crossed).error().text,
                HasSubstr("r.yaml: footprint: expected"));
    RobotMeasures flat = measures();
    flat.height = 0.0;
    EXPECT_FALSE(withMeasures(Head + Tail, "r.yaml", flat));
    EXPECT_FALSE(withMeasures("no file at all", "r.yaml", measures()));
}

TEST(RobotMeasures, OfShippedRobotsGoIntoTheUsersOwnCopy) {
    const TemporaryFolder home;
    const char* const before = std::getenv("XDG_CONFIG_HOME");
    const std::string kept = before == nullptr ? "" : before;
    setenv("XDG_CONFIG_HOME", home.path().c_str(), 1);
    const auto edit = [](const std::string& text, const std::string& name) {
        return withMeasures(text, name, measures());
    };
    const auto shipped = shippedFolder("robots") / "husky.yaml";
    const std::string original = readText(shipped);
    const auto file = editRobotFile(shipped, edit);
    if (before == nullptr)
        unsetenv("XDG_CONFIG_HOME");
    else
        setenv("XDG_CONFIG_HOME", kept.c_str(), 1);
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_EQ(*file, (home / "leitstand/robots/husky.yaml").string());
    EXPECT_EQ(readText(shipped), original);
    expectMeasures(readText(*file), measures());
    const auto own = editRobotFile(*file, [](const std::string& text, const std::string& name) {
        RobotMeasures higher = measures();
        higher.height = 0.7;
        return withMeasures(text, name, higher);
    });
    ASSERT_TRUE(own);
    EXPECT_EQ(*own, *file) << "the user's own file is changed itself";
    EXPECT_THAT(editRobotFile(home / "none.yaml", edit).error().text,
                HasSubstr("none.yaml: expected a robot's file"));
}

TEST(RobotMeasures, AllShippedFilesCanBeChanged) {
    for (const char* name :
         {"husky", "kurt3d", "crawler", "tracked", "turtlebot4", "ouster", "livox", "turtlebot"}) {
        const std::string text = readText(shippedFolder("robots") / (std::string(name) + ".yaml"));
        RobotMeasures wanted = measures();
        const auto robot = parseRobot(text, name);
        ASSERT_TRUE(robot) << robot.error().text;
        for (const auto& [sensor, described] : robot->sensors)
            wanted.sensorsInBase[sensor] = poseFrom({0.1, 0.2, 0.3}, degrees(10), degrees(20), degrees(30));
        expectMeasures(changed(text, wanted), wanted);
    }
}

}  // namespace
}  // namespace leitstand::test
