#include "app/services/station/cameras/camera_turning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

RobotDescription robotWithUnits() {
    RobotDescription robot;
    robot.name = "kurt3d";
    StreamDescription command;
    command.role = StreamRole::PanTiltCommand;
    robot.streams.push_back(command);
    robot.sensors["left"].panTilt = PanTiltMount{"left", degrees(100), degrees(60), degrees(50)};
    robot.sensors["right"].panTilt = robot.sensors["ir"].panTilt = PanTiltMount{"right"};
    robot.sensors["co2"] = {};
    return robot;
}

Event joints(const std::vector<std::string>& names, const std::vector<double>& positions) {
    JointSample sample;
    sample.names = names;
    sample.positions = positions;
    Event event;
    event.robot = "kurt3d";
    event.role = StreamRole::Joints;
    event.sample = sample;
    return event;
}

/// A station's wire as far as cameras need one.
struct FakeWire {
    GrantView cameras;
    bool mayTurn = false, mayDrive = false;
    int asked = 0, consented = 0;
    Result<void> answer;
    std::vector<PanTiltCommand> sent;

    CameraTurning::Wire wire() {
        return {
            [this](const GrantId&) { return cameras; },
            [this](const GrantId& id) { return id.kind == GrantSample::Kind::Camera ? mayTurn : mayDrive; },
            [this](const GrantId& id) {
                EXPECT_EQ(id.kind, GrantSample::Kind::Camera);
                EXPECT_EQ(id.robot, "kurt3d");
                ++asked;
            },
            [this](const GrantId&, bool consent) { consented += consent ? 1 : 0; },
            [this](const std::string&, const PanTiltCommand& command) {
                sent.push_back(command);
                return answer;
            }};
    }
};

TEST(CameraTurning, AsksForTheGrantAndSendsWhenItIsThere) {
    FakeWire fake;
    CameraTurning turning({robotWithUnits()}, fake.wire());
    turning.turnTo("kurt3d", "left", {0.3, -0.1});
    EXPECT_EQ(fake.asked, 1);
    EXPECT_TRUE(turning.pulse().ok());
    EXPECT_TRUE(fake.sent.empty());
    EXPECT_TRUE(turning.view("kurt3d", "left")->waiting);
    fake.cameras.mine = fake.mayTurn = true;
    ASSERT_TRUE(waitUntil([&] { return turning.pulse().ok() && !fake.sent.empty(); }));
    EXPECT_THAT(fake.sent[0].names, testing::ElementsAre("left_pan", "left_tilt"));
    EXPECT_THAT(fake.sent[0].positions, testing::ElementsAre(0.3, -0.1));
    EXPECT_FALSE(turning.view("kurt3d", "left")->waiting);
    turning.onEvent(joints({"left_wheels", "left_pan", "left_tilt"}, {7.0, 0.3, -0.1}));
    EXPECT_TRUE(turning.pulse().ok());
    EXPECT_EQ(turning.view("kurt3d", "left")->now, (PanTiltAngles{0.3, -0.1}));
    EXPECT_FALSE(turning.view("kurt3d", "left")->requested) << "it is there";
}

TEST(CameraTurning, TheDriverTurnsCamerasThatNobodyHolds) {
    FakeWire fake;
    fake.mayDrive = true;
    CameraTurning turning({robotWithUnits()}, fake.wire());
    turning.turnBy("kurt3d", "ir", {0.2, 0.0});
    EXPECT_TRUE(turning.pulse().ok());
    EXPECT_EQ(fake.sent.size(), 1U);
    EXPECT_EQ(turning.view("kurt3d", "right")->requested, turning.view("kurt3d", "ir")->requested)
        << "one unit";
    fake.cameras.holder = "van";
    fake.cameras.holderTitle = "The van";
    turning.turnBy("kurt3d", "ir", {0.2, 0.0});
    EXPECT_TRUE(turning.pulse().ok());
    EXPECT_EQ(fake.sent.size(), 1U) << "the van has the cameras";
    EXPECT_EQ(turning.view("kurt3d", "ir")->heldBy, "The van");
    EXPECT_TRUE(turning.view("kurt3d", "ir")->waiting);
}

TEST(CameraTurning, RecentresAllCamerasOfTheRobotInOneCommand) {
    FakeWire fake;
    fake.mayTurn = true;
    CameraTurning turning({robotWithUnits()}, fake.wire());
    turning.onEvent(joints({"left_pan", "left_tilt", "right_pan", "right_tilt"}, {0.5, 0.1, -0.4, 0.0}));
    turning.recentre("kurt3d");
    EXPECT_TRUE(turning.pulse().ok());
    ASSERT_EQ(fake.sent.size(), 1U);
    EXPECT_THAT(fake.sent[0].positions, testing::Each(0.0));
    EXPECT_EQ(fake.sent[0].names.size(), 4U);
}

TEST(CameraTurning, LeavesAloneWhatCannotBeTurned) {
    FakeWire fake;
    fake.mayTurn = true;
    RobotDescription blind = robotWithUnits();
    blind.name = "crawler";
    blind.streams.clear();
    CameraTurning turning({robotWithUnits(), blind}, fake.wire());
    for (const auto& [robot, sensor] : {std::pair("kurt3d", "co2"), std::pair("kurt3d", "none"),
                                        std::pair("crawler", "left"), std::pair("nobody", "left")}) {
        EXPECT_FALSE(turning.view(robot, sensor));
        turning.turnTo(robot, sensor, {0.1, 0.1});
        turning.setRate(robot, sensor, {0.1, 0.1});
    }
    turning.recentre("crawler");
    EXPECT_TRUE(turning.pulse().ok());
    EXPECT_TRUE(fake.sent.empty());
    EXPECT_EQ(fake.asked, 0);
}

TEST(CameraTurning, AFailureIsToldOnceAWish) {
    FakeWire fake;
    fake.mayTurn = true;
    fake.answer = Error{"gone"};
    CameraTurning turning({robotWithUnits()}, fake.wire());
    int reported = 0;
    turning.turnTo("kurt3d", "left", {0.3, 0.0});
    ASSERT_TRUE(waitUntil([&] {
        reported += turning.pulse().ok() ? 0 : 1;
        return fake.sent.size() >= 2;
    }));
    EXPECT_EQ(reported, 1);
    turning.turnTo("kurt3d", "left", {0.4, 0.0});
    EXPECT_TRUE(waitUntil([&] { return !turning.pulse().ok(); }));
}

TEST(CameraTurning, CamerasInUseAreNotGivenAway) {
    FakeWire fake;
    fake.mayTurn = fake.cameras.mine = true;
    fake.cameras.requestedBy = "van";
    CameraTurning turning({robotWithUnits()}, fake.wire());
    turning.turnTo("kurt3d", "left", {0.3, 0.0});
    EXPECT_TRUE(turning.pulse().ok());
    EXPECT_EQ(fake.consented, 0);
}

}  // namespace
}  // namespace leitstand::test
