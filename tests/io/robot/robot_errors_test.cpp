#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "tests/io/robot/robot_texts.h"

namespace leitstand::test {
namespace {

struct Case {
    std::string text, error;
};

void expectErrors(const std::vector<Case>& cases) {
    for (const Case& one : cases) {
        const auto robot = parseRobot(one.text, "r.yaml");
        ASSERT_FALSE(robot.ok()) << one.text;
        EXPECT_EQ(robot.error().text, one.error) << one.text;
    }
}

/// @p text after Whole, and the error of its line 4 (or what is given).
Case top(const std::string& text, const std::string& error, int line = 4) {
    return {Whole + text + "\n", fmt::format("r.yaml:{}: {}", line, error)};
}

/// A stream, in line 4 of a file with the sensor left.
Case stream(const std::string& keys, const std::string& error) {
    return {Head + "sensors: {left: {}}\nstreams: [{" + keys + "}]\n", "r.yaml:4: streams[0]" + error};
}

TEST(RobotErrors, TellKeysThatAreUnknownTwiceOrMissing) {
    expectErrors({
        {"{}",
         "r.yaml:1: name: expected a name as in topics (letters, digits and _, not leitstand), found "
         "nothing\n"
         "r.yaml:1: letter: expected one capital letter, found nothing\n"
         "r.yaml:1: streams: expected a list of topics, found nothing"},
        top("hight: 0.5",
            "expected one of the keys letter, name, title, drive, frames, footprint, height, limits, "
            "sensors, "
            "streams, services, joint_groups, bindings, link_loss, refine_turns or packages, found "
            "\"hight\", did you "
            "mean height?"),
        top("limits:\n  speeed: 1",
            "limits: expected one of the keys roll, pitch, speed, turn_rate, climb or step, found "
            "\"speeed\", did you mean speed?",
            5),
        top("limits:\n  weight: 1",
            "limits: expected one of the keys roll, pitch, speed, turn_rate, climb or step, found "
            "\"weight\"",
            5),
        top("height: 1\nheight: 2", "expected each key once, found \"height\" of line 4 again", 5),
        top("sensors:\n  left: {}\n  left: {}",
            "sensors: expected each key once, found \"left\" of line 5 again", 6),
        top("? [1, 2]\n: 3",
            "expected one of the keys letter, name, title, drive, frames, footprint, height, limits, "
            "sensors, "
            "streams, services, joint_groups, bindings, link_loss, refine_turns or packages, found a list of "
            "2"),
        top("sensors:\n  my camera: {}",
            "sensors: expected a name of at most 64 letters, digits and _ that begins with a letter, found "
            "\"my "
            "camera\"",
            5),
        top("sensors:\n  " + std::string(200, 'x') + ": {}",
            "sensors: expected a name of at most 64 letters, digits and _ that begins with a letter, found "
            "\"" +
                std::string(40, 'x') + "...\"",
            5),
        top("limits: 5", "limits: expected keys and values, found \"5\""),
        top("limits:", "limits: expected keys and values, found nothing"),
        {"- 1", "r.yaml:1: expected keys and values, found a list of 1"},
        {"", "r.yaml:1: expected keys and values, found nothing"},
    });
}

TEST(RobotErrors, TellWhatIsWrongWithTheRobot) {
    const std::string name =
        "name: expected a name as in topics (letters, digits and _, not leitstand), found ";
    const std::string streams = "streams: []\n";
    expectErrors({
        {"letter: K\nname: kurt 3d\n" + streams, "r.yaml:2: " + name + "\"kurt 3d\""},
        {"letter: K\nname: leitstand\n" + streams, "r.yaml:2: " + name + "\"leitstand\""},
        {"letter: k\nname: kurt3d\n" + streams, "r.yaml:1: letter: expected one capital letter, found \"k\""},
        {"letter: KK\nname: kurt3d\n" + streams,
         "r.yaml:1: letter: expected one capital letter, found \"KK\""},
        {"letter: [K]\nname: kurt3d\n" + streams,
         "r.yaml:1: letter: expected a text of 1 to 128 printable characters, found a list of 1"},
        top("title: \"a\\x1b[31m\"",
            "title: expected a text of 1 to 128 printable characters, found \"a\\x1b[31m\""),
        top("title: " + std::string(129, 'x'),
            "title: expected a text of 1 to 128 printable characters, found \"" + std::string(40, 'x') +
                "...\""),
        top("drive: tracks",
            "drive: expected differential, tracked or omnidirectional, found \"tracks\", did you mean "
            "tracked?"),
        top("drive:", "drive: expected differential, tracked or omnidirectional, found nothing"),
        top("frames: {base: /base_link}",
            "frames.base: expected a frame such as base_link, without a slash before it and without blanks, "
            "found \"/base_link\""),
        top("frames: {prefix: topics}",
            "frames.prefix: expected topic, frame or none, found \"topics\", did you mean topic?"),
        top("bindings: {forward: W, back: W}",
            "bindings.forward: expected a key or pad control of its own, found \"W\", which is that of back"),
        top("bindings: {forward: []}",
            "bindings.forward: expected a text of 1 to 128 printable characters, found a list of 0"),
        top("link_loss: {explore: finish}",
            "link_loss.explore: expected stop, finish_and_wait or return_to_link, found \"finish\""),
        top("link_loss: {teleoperation: return_to_link}",
            "link_loss.teleoperation: expected stop, since nobody drives, found \"return_to_link\""),
    });
}

TEST(RobotErrors, TellWhatIsWrongWithServices) {
    const std::string known =
        "expected std_srvs/srv/SetBool, std_srvs/srv/Trigger, irobot_create_msgs/srv/EStop, "
        "action_msgs/srv/CancelGoal or nav2_msgs/action/NavigateToPose, found ";
    expectErrors({
        top("services: 5", "services: expected a list, found \"5\""),
        top("services:\n  - {type: std_srvs/srv/Trigger}",
            "services[0].name: expected a service such as /kurt3d/e_stop, found nothing", 5),
        top("services:\n  - {name: e stop, type: std_srvs/srv/Trigger}",
            "services[0].name: expected a service such as /kurt3d/e_stop (words of letters, digits and _ "
            "that "
            "begin with no digit), found \"e stop\"",
            5),
        top("services:\n  - {name: /e_stop, type: std_srvs/srv/Setbool}",
            "services[0].type: " + known + "\"std_srvs/srv/Setbool\", did you mean std_srvs/srv/SetBool?", 5),
        top("services:\n  - {name: /e_stop}", "services[0].type: " + known + "\"\"", 5),
        top("services:\n  - {name: /e_stop, type: std_srvs/srv/SetBool, stop: yes please}",
            "services[0].stop: expected true or false, found \"yes please\"", 5),
        top("services:\n  - {name: /nav/cancel, type: action_msgs/srv/CancelGoal, stop: false}",
            "services[0].stop: expected true, since a release gives no goals back, found false", 5),
        top("services:\n  - {name: /e_stop, type: std_srvs/srv/Trigger}\n"
            "  - {name: /e_stop, type: std_srvs/srv/SetBool}",
            "services[1].name: expected a service of its own, found \"/e_stop\" of line 5 again", 6),
    });
}

TEST(RobotErrors, TellNumbersThatAreNoneOrOfAnotherUnit) {
    expectErrors({
        top("height: tall", "height: expected a number from 0.01 to 10 m, found \"tall\""),
        top("height: 0.5 m", "height: expected a number from 0.01 to 10 m, found \"0.5 m\""),
        top("height: 550", "height: expected a number from 0.01 to 10 m, found \"550\""),
        top("height: -1", "height: expected a number from 0.01 to 10 m, found \"-1\""),
        top("sensors:\n  scanner: {correction: {range: 0.3}}",
            "sensors.scanner.correction.range: expected a number from -0.2 to 0.2 m, found \"0.3\"", 5),
        top("sensors:\n  scanner: {correction: {roll: .nan}}",
            "sensors.scanner.correction.roll: expected a number from -10 to 10 degrees, found \".nan\"", 5),
        top("sensors:\n  scanner: {correction: {x: 1}}",
            "sensors.scanner.correction.x: expected a number from -0.2 to 0.2 m, found \"1\"", 5),
        top("sensors:\n  scanner: {correction: {yaw: 45}}",
            "sensors.scanner.correction.yaw: expected a number from -20 to 20 degrees, found \"45\"", 5),
        top("sensors:\n  scanner: {correction: {clock: -1}}",
            "sensors.scanner.correction.clock: expected a number from -0.5 to 0.5 s, found \"-1\"", 5),
        top("sensors:\n  scanner: {correction: {lean: 1}}",
            "sensors.scanner.correction: expected one of the keys range, roll, pitch, x, y, yaw or clock, "
            "found \"lean\"",
            5),
        top("height: .nan", "height: expected a number from 0.01 to 10 m, found \".nan\""),
        top("height: nan", "height: expected a number from 0.01 to 10 m, found \"nan\""),
        top("height: 1e999", "height: expected a number from 0.01 to 10 m, found \"1e999\""),
        top("height: 0,5", "height: expected a number from 0.01 to 10 m, found \"0,5\""),
        top("refine_turns: 1", "refine_turns: expected true or false, found \"1\""),
        top("limits: {roll: 0.4}", "limits.roll: expected a number from 1 to 180 degrees, found \"0.4\""),
        top("limits: {pitch: .inf}", "limits.pitch: expected a number from 1 to 180 degrees, found \".inf\""),
        top("limits: {speed: 300}", "limits.speed: expected a number from 0.01 to 20 m/s, found \"300\""),
        top("limits: {turn_rate: 0.5}",
            "limits.turn_rate: expected a number from 1 to 720 degrees/s, found \"0.5\""),
        top("limits: {climb: 0.36}", "limits.climb: expected a number from 1 to 60 degrees, found \"0.36\""),
        top("limits: {step: 50}", "limits.step: expected a number from 0.01 to 1 m, found \"50\""),
        top("sensors: {imu: {position: [1, 2]}}",
            "sensors.imu.position: expected 3 numbers from -10 to 10 m, found a list of 2"),
        top("sensors: {imu: {position: [1, 2, 300]}}",
            "sensors.imu.position: expected 3 numbers from -10 to 10 m, found \"300\""),
        top("sensors: {left: {pan_tilt: {pan: 200}}}",
            "sensors.left.pan_tilt.pan: expected a number from 0 to 180 degrees, found \"200\""),
        top("sensors: {laser: {motion: spiral}}",
            "sensors.laser.motion: expected fixed, turning or tilting, found \"spiral\""),
        top("sensors: {imu: {rotation: [1, 2, x]}}",
            "sensors.imu.rotation: expected 3 numbers from -360 to 360 degrees, found \"x\""),
    });
}

TEST(RobotErrors, TellOutlinesThatAreNone) {
    expectErrors({
        top("footprint: 0.5", "footprint: expected a list of corners, found \"0.5\""),
        top("footprint: []", "footprint: expected 3 to 64 corners, found 0"),
        top("footprint: [[0, 0], [1, 0]]", "footprint: expected 3 to 64 corners, found 2"),
        top("footprint: [[0, 0], [1, 0], [300, 1]]",
            "footprint[2]: expected [x, y], each from -10 to 10 m, found a list of 2"),
        top("footprint: [[0, 0], [1, 0], 1]",
            "footprint[2]: expected [x, y], each from -10 to 10 m, found \"1\""),
        top("footprint: [[0, 0], [1, 1], [1, 0], [0, 1]]",
            "footprint: expected sides that do not cross, found side 1 crossing side 3"),
        top("footprint: [[0, 0], [1, 0], [1, 0], [0, 1]]",
            "footprint: expected corners that differ, found [1, 0] twice in a row"),
        top("footprint: [[0, 0], [0.01, 0], [0, 0.01]]",
            "footprint: expected an area, found 5e-05 square metres"),
    });
}

/// "points, ranges or ping".
std::string allRoles() {
    std::string text;
    const auto roles = allStreamRoles();
    for (std::size_t i = 0; i < roles.size(); ++i)
        text += (i == 0 ? "" : i + 1 == roles.size() ? " or " : ", ") + toString(roles[i]);
    return text;
}

TEST(RobotErrors, TellWhatIsWrongWithAStream) {
    const std::string topic =
        "expected a topic such as /kurt3d/odom (words of letters, digits and _ that begin with no digit), "
        "found ";
    expectErrors({
        stream("topic: /a", ".role: expected what the topic carries, such as points, found nothing"),
        stream("role: point", ".role: expected " + allRoles() + ", found \"point\", did you mean points?"),
        stream("role: imu, topic: odom", ".topic: " + topic + "\"odom\""),
        stream("role: imu, topic: /odom/", ".topic: " + topic + "\"/odom/\""),
        stream("role: imu, topic: /a//b", ".topic: " + topic + "\"/a//b\""),
        stream("role: imu, topic: /2d", ".topic: " + topic + "\"/2d\""),
        stream("role: imu, topic: /a b", ".topic: " + topic + "\"/a b\""),
        stream("role: imu, topic: /leitstand/grants",
               ".topic: expected a topic of the robot, found one of the stations: \"/leitstand/grants\""),
        stream("role: imu, type: sensor_msgs/Imu",
               ".type: expected sensor_msgs/msg/Imu for imu, found \"sensor_msgs/Imu\", did you mean "
               "sensor_msgs/msg/Imu?"),
        stream("role: drive_command, type: nav_msgs/msg/Odometry",
               ".type: expected geometry_msgs/msg/Twist or geometry_msgs/msg/TwistStamped for drive_command, "
               "found \"nav_msgs/msg/Odometry\""),
        stream("role: picture",
               ".sensor: expected the camera that it belongs to, a name under sensors, found nothing"),
        stream("role: picture, sensor: lefd",
               ".sensor: expected left (under sensors), found \"lefd\", did you mean left?"),
        stream("role: imu, stamp: zero",
               ".stamp: expected it only for commands that have a stamp, found it for imu of type "
               "sensor_msgs/msg/Imu"),
        stream("role: drive_command, stamp: zero",
               ".stamp: expected it only for commands that have a stamp, found it for drive_command of type "
               "geometry_msgs/msg/Twist"),
        stream("role: drive_command, type: geometry_msgs/msg/TwistStamped, stamp: now",
               ".stamp: expected robot, zero or station, found \"now\""),
        stream(
            "role: imu, hardware_id: x",
            ".hardware_id: expected it only for diagnostics, found it for imu of type sensor_msgs/msg/Imu"),
        stream("role: picture, sensor: left, thermal: {}",
               ".thermal: expected it only for thermal, found it for picture of type "
               "sensor_msgs/msg/CompressedImage"),
        stream("role: thermal, sensor: left, thermal: {scale: 0}",
               ".thermal.scale: expected a number from 1e-06 to 100 K, found \"0\""),
        stream("role: thermal, sensor: left, thermal: {measured: maybe}",
               ".thermal.measured: expected true or false, found \"maybe\""),
        stream("role: imu, maps: true",
               ".maps: expected it only for points and ranges, found it for imu of type sensor_msgs/msg/Imu"),
        stream("role: points, maps: 2", ".maps: expected true or false, found \"2\""),
        stream("role: imu, record: 1", ".record: expected true or false, found \"1\""),
    });
    const auto robot = parseRobot(Head + "streams:\n- {role: imu, sensor: left}\n", "r.yaml");
    EXPECT_EQ(robot.error().text,
              "r.yaml:4: streams[0].sensor: expected a name under sensors, which has none, found \"left\"");
}

TEST(RobotErrors, TellWhatIsWrongWithQos) {
    const auto qos = [](const std::string& keys, const std::string& error) {
        return stream("role: imu, qos: {" + keys + "}", ".qos" + error);
    };
    expectErrors({
        qos("reliability: besteffort",
            ".reliability: expected best_effort or reliable, found \"besteffort\", did you mean "
            "best_effort?"),
        qos("durability: persistent",
            ".durability: expected volatile or transient_local, found \"persistent\""),
        qos("depth: 1.5", ".depth: expected a whole number from 0 to 100000, found \"1.5\""),
        qos("depth: 99999999999999999999",
            ".depth: expected a whole number from 0 to 100000, found \"99999999999999999999\""),
        qos("depth: -1", ".depth: expected a whole number from 0 to 100000, found \"-1\""),
        qos("lifespan: -1", ".lifespan: expected a number from 0 to 86400 s, found \"-1\""),
        qos("deadline: inf", ".deadline: expected a number from 0 to 86400 s, found \"inf\""),
        qos("history: 3",
            ": expected one of the keys reliability, durability, depth, lifespan or deadline, found "
            "\"history\""),
        stream("role: stop_command, qos: {lifespan: 0.3}",
               ".qos.lifespan: expected 0, since a stop never grows old, found \"0.3\""),
    });
}

TEST(RobotErrors, TellStreamsThatAreThereTwice) {
    expectErrors({
        {Head + "streams:\n  - {role: points}\n  - {role: points}\n",
         "r.yaml:5: streams[1].topic: expected a topic of its own, found \"/kurt3d/points\" of line 4 again"},
        {Head + "streams:\n  - {role: imu}\n  - role: gas\n    topic: /kurt3d/imu\n",
         "r.yaml:6: streams[1].topic: expected a topic of its own, found \"/kurt3d/imu\" of line 4 again"},
        {Head + "streams:\n  - {role: odometry}\n  - {role: odometry, topic: /other}\n",
         "r.yaml:5: streams[1].role: expected one stream of this role, found \"odometry\" of line 4 again"},
        {Head + "streams: {role: imu}\n", "r.yaml:3: streams: expected a list, found keys and values"},
        {Head + "streams: [imu]\n", "r.yaml:3: streams[0]: expected keys and values, found \"imu\""},
    });
}

TEST(RobotErrors, TellYamlThatIsNotTaken) {
    expectErrors({
        top("title: &a x", "expected no anchor, found one (&name)"),
        {"a: &a [x]\nb: *a\n", "r.yaml:1: expected no anchor, found one (&name)"},
        top("title: !!str x", "expected no tag, found \"tag:yaml.org,2002:str\""),
        top("title: !mine x", "expected no tag, found \"!mine\""),
        top("---\nletter: K", "expected one YAML document, found a second one"),
        top("limits:\n\troll: 20", "expected spaces before the first word, found a tab", 5),
        top("a: " + std::string(17, '['), "expected at most 16 levels, found more"),
        top("a: [1", "expected YAML, found a mistake: end of sequence flow not found", 5),
        {std::string("letter: K\nname: \0", 17), "r.yaml:2: expected UTF-8 text, found byte 0x00"},
        {"\x89PNG\r\n", "r.yaml:1: expected UTF-8 text, found byte 0x89"},
        {"letter: K\nname: k\xC3\n", "r.yaml:2: expected UTF-8 text, found byte 0xc3"},
        {std::string(300'000, ' '), "r.yaml: expected at most 262144 bytes, found more"},
    });
}

TEST(RobotErrors, AreToldAllAtOnceInTheOrderOfTheFile) {
    const auto robot = parseRobot(
        "name: kurt3d\n"
        "streams:\n"
        "  - role: picture\n"
        "    sensor: lefft\n"
        "  - {role: imu, qos: {depth: x}}\n"
        "sensors:\n"
        "  left: {position: 3}\n"
        "limits: {speed: -1}\n"
        "letter: x\n",
        "r.yaml");
    ASSERT_FALSE(robot.ok());
    EXPECT_EQ(
        robot.error().text,
        "r.yaml:4: streams[0].sensor: expected left (under sensors), found \"lefft\", did you mean left?\n"
        "r.yaml:5: streams[1].qos.depth: expected a whole number from 0 to 100000, found \"x\"\n"
        "r.yaml:7: sensors.left.position: expected 3 numbers from -10 to 10 m, found \"3\"\n"
        "r.yaml:8: limits.speed: expected a number from 0.01 to 20 m/s, found \"-1\"\n"
        "r.yaml:9: letter: expected one capital letter, found \"x\"");
}

TEST(RobotErrors, AreCountedWhenThereAreHundreds) {
    std::string text = Whole + "limits:\n";
    for (int i = 0; i < 150; ++i) text += fmt::format("  key{}: 1\n", i);
    const auto robot = parseRobot(text, "r.yaml");
    ASSERT_FALSE(robot.ok());
    EXPECT_TRUE(robot.error().text.ends_with("\nr.yaml: 50 errors more"));
}

TEST(RobotErrors, TellFilesThatCannotBeRead) {
    EXPECT_EQ(readRobot("/nowhere/r.yaml").error().text,
              "/nowhere/r.yaml: expected a robot's file, found none that can be read");
    EXPECT_FALSE(readRobot("/").ok());
}

}  // namespace
}  // namespace leitstand::test
