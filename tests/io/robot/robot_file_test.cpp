#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"
#include "tests/io/robot/robot_texts.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

void expectSame(const JointGroup& a, const JointGroup& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.mode, b.mode);
    EXPECT_EQ(a.axes, b.axes);
    EXPECT_EQ(a.presets, b.presets);
    ASSERT_EQ(a.joints.size(), b.joints.size());
    for (std::size_t i = 0; i < a.joints.size(); ++i) {
        const MovedJoint &one = a.joints[i], &other = b.joints[i];
        EXPECT_EQ(one.name, other.name);
        EXPECT_EQ(one.type, other.type);
        EXPECT_EQ(one.reversed, other.reversed);
        EXPECT_EQ(one.link, other.link);
        EXPECT_NEAR(one.rate, other.rate, 1e-11);
        ASSERT_EQ(one.lower.has_value(), other.lower.has_value());
        ASSERT_EQ(one.upper.has_value(), other.upper.has_value());
        EXPECT_NEAR(one.lower.value_or(0.0), other.lower.value_or(0.0), 1e-11);
        EXPECT_NEAR(one.upper.value_or(0.0), other.upper.value_or(0.0), 1e-11);
    }
}

void expectSame(const RobotDescription& a, const RobotDescription& b) {
    EXPECT_EQ(a.letter, b.letter);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.streams, b.streams);
    EXPECT_EQ(a.baseFrame, b.baseFrame);
    EXPECT_EQ(a.odomFrame, b.odomFrame);
    EXPECT_EQ(a.tfPrefix, b.tfPrefix);
    EXPECT_EQ(a.footprint, b.footprint);
    EXPECT_EQ(a.height, b.height);
    EXPECT_NEAR(a.maxRoll, b.maxRoll, 1e-11);  // degrees have twelve digits
    EXPECT_NEAR(a.maxPitch, b.maxPitch, 1e-11);
    EXPECT_EQ(a.maxSpeed, b.maxSpeed);
    EXPECT_NEAR(a.maxTurnRate, b.maxTurnRate, 1e-10);
    EXPECT_NEAR(a.maxClimb, b.maxClimb, 1e-11);
    EXPECT_EQ(a.maxStep, b.maxStep);
    EXPECT_EQ(a.refineTurns, b.refineTurns);
    EXPECT_EQ(a.drive, b.drive);
    EXPECT_EQ(a.bindings, b.bindings);
    EXPECT_EQ(a.linkLoss, b.linkLoss);
    ASSERT_EQ(a.jointGroups.size(), b.jointGroups.size());
    for (std::size_t i = 0; i < a.jointGroups.size(); ++i) expectSame(a.jointGroups[i], b.jointGroups[i]);
    ASSERT_EQ(a.sensors.size(), b.sensors.size());
    for (const auto& [name, sensor] : a.sensors) {
        ASSERT_TRUE(b.sensors.contains(name)) << name;
        EXPECT_EQ(sensor.frame, b.sensors.at(name).frame);
        EXPECT_EQ(sensor.motion, b.sensors.at(name).motion);
        EXPECT_TRUE(sensor.sensorInBase.isApprox(b.sensors.at(name).sensorInBase, 1e-9)) << name;
        EXPECT_EQ(sensor.correction.range, b.sensors.at(name).correction.range) << name;
        EXPECT_NEAR(sensor.correction.roll, b.sensors.at(name).correction.roll, 1e-12) << name;
        EXPECT_NEAR(sensor.correction.pitch, b.sensors.at(name).correction.pitch, 1e-12) << name;
        EXPECT_EQ(sensor.correction.x, b.sensors.at(name).correction.x) << name;
        EXPECT_EQ(sensor.correction.y, b.sensors.at(name).correction.y) << name;
        EXPECT_NEAR(sensor.correction.yaw, b.sensors.at(name).correction.yaw, 1e-12) << name;
        EXPECT_EQ(sensor.correction.clock, b.sensors.at(name).correction.clock) << name;
        const auto& turned = b.sensors.at(name).panTilt;
        ASSERT_EQ(sensor.panTilt.has_value(), turned.has_value()) << name;
        if (!turned) continue;
        EXPECT_EQ(sensor.panTilt->unit, turned->unit);
        EXPECT_NEAR(sensor.panTilt->pan, turned->pan, 1e-11);
        EXPECT_NEAR(sensor.panTilt->up, turned->up, 1e-11);
        EXPECT_NEAR(sensor.panTilt->down, turned->down, 1e-11);
    }
}

TEST(RobotFile, NeedsOnlyALetterANameAndStreams) {
    const auto robot = parseRobot(Whole, "r.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    EXPECT_EQ(robot->title, "kurt3d");
    EXPECT_EQ(robot->baseFrame, "base_link");
    EXPECT_EQ(robot->odomFrame, "odom");
    EXPECT_EQ(robot->footprint.size(), 4u);
    EXPECT_EQ(robot->height, 0.5);
    EXPECT_NEAR(inDegrees(robot->maxRoll), 25.0, 1e-9);
    EXPECT_NEAR(inDegrees(robot->maxTurnRate), 30.0, 1e-9);
    EXPECT_EQ(robot->maxSpeed, 0.3);
    ASSERT_EQ(robot->streams.size(), 1u);
    EXPECT_EQ(robot->streams[0], defaultStream(StreamRole::Points, "kurt3d", ""));
}

TEST(RobotFile, ReadsYamlAsEditorsWriteIt) {
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : Whole + "title: \"K\xC3\xBCrt\"\n\t# a comment\n") {
        if (c == '\n') windows += '\r';
        windows += c;
    }
    const auto robot = parseRobot(windows, "r.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    EXPECT_EQ(robot->name, "kurt3d");
    EXPECT_EQ(robot->title, "K\xC3\xBCrt");
}

TEST(RobotFile, TellsRampsAndStepsWhereTheyAreNotTheUsualOnes) {
    const auto usual = parseRobot(Whole, "r.yaml");
    ASSERT_TRUE(usual.ok()) << usual.error().text;
    EXPECT_EQ(usual->maxClimb, 0.0);
    EXPECT_EQ(usual->maxStep, 0.0);
    const auto robot = parseRobot(Whole + "limits: {climb: 35, step: 0.2}\n", "r.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    EXPECT_NEAR(inDegrees(robot->maxClimb), 35.0, 1e-9);
    EXPECT_EQ(robot->maxStep, 0.2);
}

TEST(RobotFile, RefinesTurnsOnlyWhereItIsTold) {
    EXPECT_FALSE(parseRobot(Whole, "r.yaml").value().refineTurns);
    EXPECT_FALSE(parseRobot(Whole + "refine_turns: false\n", "r.yaml").value().refineTurns);
    EXPECT_TRUE(parseRobot(Whole + "refine_turns: true\n", "r.yaml").value().refineTurns);
}

TEST(RobotFile, TurnsAClockwiseOutlineAround) {
    const auto robot = parseRobot(Whole + "footprint: [[0, 0], [0, 1], [1, 0]]\n", "r.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    EXPECT_THAT(robot->footprint,
                testing::ElementsAre(Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(0, 0)));
}

TEST(RobotFile, ChoosesTopicsByTypeAndPrefix) {
    const auto robot =
        parseRobot(Head +
                       "frames: {prefix: frame}\nsensors: {left: {}}\nstreams:\n- {role: transforms}\n"
                       "- {role: picture, sensor: left, type: sensor_msgs/msg/Image}\n",
                   "r.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    EXPECT_EQ(robot->streams[0].topic, "/tf");
    EXPECT_EQ(robot->streams[1].topic, "/kurt3d/left/image");
}

TEST(RobotFile, WhatProbeWritesHasAPlaceForEachCamera) {
    RobotDescription guess;
    guess.name = "robot";
    guess.letter = "R";
    guess.title = "Robot";
    guess.streams.push_back(defaultStream(StreamRole::Picture, "robot", "front"));
    const auto robot = parseRobot(writeRobot(guess), "r.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    EXPECT_TRUE(robot->sensors.contains("front"));
}

class ShippedRobot : public testing::TestWithParam<std::string> {};

TEST_P(ShippedRobot, IsReadAndWrittenWithoutALoss) {
    const auto robot = readRobot(ShippedRobots / (GetParam() + ".yaml"));
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    if (GetParam() != "husky") {  // it has the name of its namespace
        EXPECT_EQ(robot->name, GetParam());
    }
    const auto again = parseRobot(writeRobot(*robot), "again");
    ASSERT_TRUE(again.ok()) << again.error().text;
    expectSame(*robot, *again);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedRobot, testing::ValuesIn(shippedRobots({ShippedRobots})));

TEST(ShippedRobots, SayWhatDesignSays) {
    const auto robot = readRobot(ShippedRobots / "kurt3d.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    std::vector<std::string> topics;
    for (const StreamDescription& stream : robot->streams) topics.push_back(stream.topic);
    EXPECT_THAT(topics,
                testing::IsSupersetOf({"/kurt3d/points", "/kurt3d/odom", "/kurt3d/tf", "/kurt3d/tf_static",
                                       "/kurt3d/left/image/compressed", "/kurt3d/right/image/compressed",
                                       "/kurt3d/ir/image/compressed", "/kurt3d/co2", "/kurt3d/battery_state",
                                       "/diagnostics", "/kurt3d/cmd_vel", "/kurt3d/stop_cmd",
                                       "/kurt3d/stop_state", "/kurt3d/ptu_cmd", "/kurt3d/goal_pose"}));
    const Qos& points = robot->stream(StreamRole::Points)->qos;
    EXPECT_EQ(points.depth, 600);
    EXPECT_EQ(points.reliability, Qos::Reliability::Reliable);
}

/// Descriptions with anything that a file can say.
class RandomRobot {
public:
    explicit RandomRobot(unsigned seed) : m_random(seed) {}

    RobotDescription next() {
        RobotDescription robot;
        robot.name = word();
        robot.letter = std::string(1, static_cast<char>('A' + below(26)));
        robot.title = title();
        robot.drive = static_cast<DriveType>(below(3));
        robot.tfPrefix = static_cast<TfPrefix>(below(3));
        robot.baseFrame = word();
        robot.odomFrame = robot.name + "/" + word();
        const double x = number(0.05, 5.0), y = number(0.05, 5.0);
        robot.footprint = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
        robot.height = number(0.02, 9.0);
        robot.maxRoll = degrees(number(1.1, 179.0));
        robot.maxPitch = degrees(number(1.1, 179.0));
        robot.maxTurnRate = degrees(number(1.1, 700.0));
        robot.maxSpeed = number(0.02, 19.0);
        if (below(2) == 0) robot.maxClimb = degrees(number(1.1, 59.0));
        if (below(2) == 0) robot.maxStep = number(0.02, 0.9);
        robot.refineTurns = below(2) == 0;
        for (int i = below(5); i >= 0; --i) {
            robot.sensors[word()] = {word(), poseFrom({number(-9, 9), number(-9, 9), number(-9, 9)},
                                                      number(-3, 3), number(-1.5, 1.5), number(-3, 3))};
        }
        if (below(2) == 0)
            robot.sensors.begin()->second.correction = {
                number(-0.2, 0.2), degrees(number(-9, 9)),   degrees(number(-9, 9)), number(-0.2, 0.2),
                number(-0.2, 0.2), degrees(number(-19, 19)), number(-0.5, 0.5)};
        robot.sensors.begin()->second.panTilt = {word(), degrees(number(0, 179)), degrees(number(0, 179)),
                                                 degrees(number(0, 179))};
        addStreams(robot);
        for (int i = below(4); i > 0; --i) robot.bindings[word()] = fmt::format("{} {}", title(), i);
        for (int i = below(4); i > 0; --i) robot.linkLoss[word()] = static_cast<LinkLossRule>(below(3));
        return robot;
    }

private:
    void addStreams(RobotDescription& robot) {
        int number = 0;
        for (const StreamRole role : allStreamRoles()) {
            if (below(3) == 0) continue;
            const bool camera = streamFacts(role).ofCamera;
            StreamDescription stream = defaultStream(role, robot.name, {});
            if (camera || below(2) == 0) {
                stream.sensor = std::next(robot.sensors.begin(), below(int(robot.sensors.size())))->first;
            }
            const auto types = typesOf(role);
            stream.type = types[static_cast<std::size_t>(below(int(types.size())))];
            if (isDepthStream(stream) && stream.sensor.empty()) stream.sensor = robot.sensors.begin()->first;
            stream.topic = fmt::format("/{}/{}{}", word(), word(), ++number);
            stream.qos = {static_cast<Qos::Reliability>(below(2)), static_cast<Qos::Durability>(below(2)),
                          below(1000), role == StreamRole::StopCommand ? 0.0 : below(100) / 7.0,
                          below(100) / 3.0};
            if (isCommand(role) && stream.type != "geometry_msgs/msg/Twist")
                stream.stamp = static_cast<StampSource>(below(3));
            if (role == StreamRole::Thermal)
                stream.thermal = {0.1 / (1 + below(9)), 1.0 / 3.0, below(2) == 0};
            if (role == StreamRole::Diagnostics) stream.hardwareId = below(2) == 0 ? "" : title();
            if (role == StreamRole::JointCommand) addGroup(robot, stream);
            if (role == StreamRole::Reading) addReadings(stream);
            stream.record = below(2) == 0;
            stream.maps = role == StreamRole::Points && below(2) == 0;
            robot.streams.push_back(stream);
        }
    }

    void addReadings(StreamDescription& stream) {
        stream.readings = usualReadings(stream.type);
        if (below(2) == 0) return;
        stream.readings = {{"temperature", "Air", "°C", 0.5, -3.0, 2, {-10.0, 40.0, {}, 60.0}},
                           {"cells[2].voltage", title(), "", 1.0, 0.0, {}, {{}, {}, 1.0 / 3.0, {}}}};
    }
    /// Adds a group of joints that @p stream commands. Positions are whole degrees, which files hold exactly.
    void addGroup(RobotDescription& robot, StreamDescription& stream) {
        JointGroup group;
        group.name = stream.group = word();
        group.title = title();
        const bool trajectories = stream.type == "trajectory_msgs/msg/JointTrajectory";
        group.mode = trajectories ? JointCommandMode::Position : static_cast<JointCommandMode>(below(2));
        for (int i = below(4); i >= 0; --i) {
            MovedJoint joint;
            joint.name = fmt::format("{} {}", title(), i);
            joint.type = static_cast<JointType>(below(2));
            const double one = joint.type == JointType::Revolute ? degrees(1) : 0.125;
            if (joint.type == JointType::Prismatic || below(2) == 0) joint.lower = -one * below(40);
            if (joint.type == JointType::Prismatic || below(2) == 0) joint.upper = one * (1 + below(40));
            joint.rate = one * (1 + below(9));
            joint.reversed = below(2) == 0;
            if (below(2) == 0)
                joint.link =
                    JointLink{{number(-1, 1), number(-1, 1)}, number(0.1, 1), degrees(below(90)), {}};
            if (joint.link && !group.joints.empty()) joint.link->parent = group.joints.front().name;
            group.joints.push_back(joint);
        }
        group.axes = {{title(), {0}}, {title(), {group.joints.size() - 1}}};
        group.presets = {{title(), std::vector<double>(group.joints.size(), 0.0)}};
        robot.jointGroups.push_back(group);
    }
    int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(m_random); }
    double number(double from, double to) { return std::uniform_real_distribution<>(from, to)(m_random); }
    std::string word() {
        static constexpr const char* Words[] = {"null", "true", "yes", "n",  "kurt3d",
                                                "e1",   "x_y",  "Nan", "inf"};
        return Words[below(9)] + std::string(below(2) == 0 ? "" : "_") + std::to_string(below(50));
    }
    std::string title() {
        static constexpr const char* Titles[] = {"~",           "null", "K: #1", "'",   "\"",  "[a]",
                                                 "&a",          "*b",   "true",  "- x", " a ", "{",
                                                 "K\xC3\xBCrt", "0x10", "%",     "!x"};
        return Titles[below(16)];
    }

    std::mt19937 m_random;
};

TEST(RobotFile, WritesWhatItReadsAgain) {
    RandomRobot random(7);
    for (int i = 0; i < 300; ++i) {
        const RobotDescription robot = random.next();
        const std::string text = writeRobot(robot);
        const auto again = parseRobot(text, "again");
        ASSERT_TRUE(again.ok()) << again.error().text << '\n' << text;
        expectSame(robot, *again);
        ASSERT_FALSE(HasFailure()) << text;
    }
}

/// No text, however broken, does more than be told.
TEST(RobotFile, KeepsHowASensorSitsThatLooksStraightUp) {
    for (const double pitch : {-90.0, 90.0, -89.9999}) {
        RobotDescription robot = *readRobot(ShippedRobots / "kurt3d.yaml");
        Pose& sits = robot.sensors.begin()->second.sensorInBase;
        sits = poseFrom({0.1, 0, 0.5}, degrees(20), degrees(pitch), degrees(70));
        const auto again = parseRobot(writeRobot(robot), "again");
        ASSERT_TRUE(again.ok()) << again.error().text;
        const Pose& read = again->sensors.at(robot.sensors.begin()->first).sensorInBase;
        EXPECT_LT((read.matrix() - sits.matrix()).cwiseAbs().maxCoeff(), 1e-9) << pitch;
    }
}

TEST(RobotFile, TakesNoHarmFromDamagedFiles) {
    std::mt19937 random(11);
    const auto below = [&random](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    int reported = 0;
    for (const auto& entry : std::filesystem::directory_iterator(ShippedRobots)) {
        const std::string whole = readText(entry.path());
        for (int i = 0; i < 400; ++i) {
            std::string text = whole;
            if (i % 4 == 0) text.resize(below(text.size()));
            for (std::size_t flips = 1 + below(4); flips > 0 && !text.empty(); --flips) {
                const std::size_t place = below(text.size());
                if (i % 3 == 0) {
                    text[place] = static_cast<char>(below(256));
                } else {
                    text[place] = "{}[]:,-#&*!|>'\"%@`? \n\t0aA"[below(26)];
                }
            }
            const auto robot = parseRobot(text, "r.yaml");
            if (robot.ok()) continue;
            ++reported;
            ASSERT_TRUE(robot.error().text.starts_with("r.yaml:")) << robot.error().text;
        }
    }
    EXPECT_GT(reported, 600);
}

}  // namespace
}  // namespace leitstand::test
