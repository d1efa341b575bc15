#include "core/io/robot/robot_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "core/io/robot/robot_words.h"
#include "core/io/robot/yaml_document.h"
#include "core/io/robot/yaml_fields.h"
#include "core/robot/stream_defaults.h"

namespace leitstand {
namespace {

using detail::YamlErrors;
using detail::YamlFields;

constexpr double LargestSize = 100.0;     ///< of robots and sensor places [m]
constexpr double LargestAngle = 360.0;    ///< [degrees]
constexpr double LargestSpeed = 50.0;     ///< [m/s]
constexpr double LongestTime = 86'400.0;  ///< [s]
constexpr int DeepestHistory = 100'000;

bool isName(const std::string& text) {
    return !text.empty() && text.size() <= 64 &&
           std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
           std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

bool isTopic(const std::string& text) {
    return text.size() > 1 && text.size() <= 255 && text.front() == '/' && text.back() != '/' &&
           std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '/'; });
}

/// "nav_msgs/msg/Odometry"
bool isType(const std::string& text) {
    const auto first = text.find('/'), second = text.find('/', first + 1);
    return second != std::string::npos && isName(text.substr(0, first)) && isName(text.substr(second + 1)) &&
           text.substr(first + 1, second - first - 1) == "msg";
}

void readQos(const YAML::Node& node, const std::string& path, Qos& qos, YamlErrors& errors) {
    const YamlFields fields(node, path, {"reliability", "durability", "depth", "lifespan", "deadline"},
                            errors);
    fields.choice("reliability", qos.reliability, detail::reliabilityWords());
    fields.choice("durability", qos.durability, detail::durabilityWords());
    fields.count("depth", qos.depth, 0, DeepestHistory);
    fields.number("lifespan", qos.lifespan, 0.0, LongestTime);
    fields.number("deadline", qos.deadline, 0.0, LongestTime);
}

void readThermal(const YAML::Node& node, const std::string& path, ThermalScale& thermal, YamlErrors& errors) {
    const YamlFields fields(node, path, {"scale", "offset", "measured"}, errors);
    fields.number("scale", thermal.scale, 1e-6, 100.0);
    fields.number("offset", thermal.offset, -1000.0, 1000.0);
    fields.flag("measured", thermal.measured);
}

void readStream(const YAML::Node& node, const std::string& path, RobotDescription& robot,
                YamlErrors& errors) {
    const YamlFields fields(
        node, path, {"role", "sensor", "topic", "type", "qos", "stamp", "thermal", "hardware_id", "record"},
        errors);
    StreamRole role = StreamRole::Points;
    if (!fields.has("role")) return fields.fail("role", "expected what the topic carries, such as points");
    fields.choice("role", role, detail::roleWords());
    std::string sensor;
    fields.text("sensor", sensor);
    StreamDescription stream = defaultStream(role, robot.name, sensor);
    fields.text("topic", stream.topic);
    fields.text("type", stream.type);
    if (!isTopic(stream.topic))
        fields.fail("topic", "expected a ROS topic like /kurt3d/odom, found \"" + stream.topic + '"');
    if (!isType(stream.type)) {
        fields.fail("type", "expected a ROS type like nav_msgs/msg/Odometry, found \"" + stream.type + '"');
    }
    if (fields.has("qos")) readQos(node["qos"], fields.pathOf("qos"), stream.qos, errors);
    fields.choice("stamp", stream.stamp, detail::stampWords());
    if (fields.has("thermal")) readThermal(node["thermal"], fields.pathOf("thermal"), stream.thermal, errors);
    fields.text("hardware_id", stream.hardwareId);
    fields.flag("record", stream.record);
    const bool again =
        std::any_of(robot.streams.begin(), robot.streams.end(),
                    [&](const StreamDescription& other) { return other.topic == stream.topic; });
    if (again) fields.fail("topic", "topic " + stream.topic + " is listed twice");
    robot.streams.push_back(std::move(stream));
}

void readSensor(const YAML::Node& node, const std::string& name, const std::string& path,
                RobotDescription& robot, YamlErrors& errors) {
    const YamlFields fields(node, path, {"frame", "position", "rotation"}, errors);
    SensorDescription sensor;
    sensor.frame = name;
    fields.text("frame", sensor.frame);
    auto position = fields.numbers("position", 3, LargestSize),
         rotation = fields.numbers("rotation", 3, LargestAngle);
    position.resize(3, 0.0);
    rotation.resize(3, 0.0);
    sensor.sensorInBase = poseFrom({position[0], position[1], position[2]}, degrees(rotation[0]),
                                   degrees(rotation[1]), degrees(rotation[2]));
    if (!isName(name))
        errors.add(node, path, "expected a name of letters, digits and _, found \"" + name + '"');
    robot.sensors.emplace(name, sensor);
}

void readFootprint(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    fields.each("footprint", false,
                [&](const YAML::Node& corner, const std::string&, const std::string& path) {
                    if (corner.IsSequence() && corner.size() == 2) {
                        try {
                            const Eigen::Vector2d point(corner[0].as<double>(), corner[1].as<double>());
                            if (point.allFinite() && point.norm() <= LargestSize)
                                return robot.footprint.push_back(point);
                        } catch (const YAML::Exception&) {  // told below
                        }
                    }
                    errors.add(corner, path, "expected [x, y] in metres");
                });
    if (fields.has("footprint") && robot.footprint.size() < 3)
        fields.fail("footprint", "expected three corners or more");
}

void readLimits(const YAML::Node& node, RobotDescription& robot, YamlErrors& errors) {
    const YamlFields fields(node, "limits", {"roll", "pitch", "speed", "turn_rate"}, errors);
    double roll = inDegrees(robot.maxRoll), pitch = inDegrees(robot.maxPitch),
           turn = inDegrees(robot.maxTurnRate);
    fields.number("roll", roll, 0.0, 180.0);
    fields.number("pitch", pitch, 0.0, 180.0);
    fields.number("speed", robot.maxSpeed, 0.0, LargestSpeed);
    fields.number("turn_rate", turn, 0.0, 3600.0);
    robot.maxRoll = degrees(roll);
    robot.maxPitch = degrees(pitch);
    robot.maxTurnRate = degrees(turn);
}

void readIdentity(const YamlFields& fields, RobotDescription& robot) {
    fields.text("name", robot.name);
    fields.text("letter", robot.letter);
    robot.title = robot.name;
    fields.text("title", robot.title);
    if (!isName(robot.name)) {
        fields.fail("name", "expected a name as in topics (letters, digits, _), found \"" + robot.name + '"');
    }
    if (robot.letter.size() != 1 || std::isupper(static_cast<unsigned char>(robot.letter.front())) == 0) {
        fields.fail("letter", "expected one capital letter, found \"" + robot.letter + '"');
    }
}

void readFrames(const YAML::Node& node, RobotDescription& robot, YamlErrors& errors) {
    const YamlFields fields(node, "frames", {"base", "odom", "prefix"}, errors);
    fields.text("base", robot.baseFrame);
    fields.text("odom", robot.odomFrame);
    fields.choice("prefix", robot.tfPrefix, detail::prefixWords());
}

RobotDescription readAll(const YAML::Node& root, YamlErrors& errors) {
    const YamlFields fields(root, "",
                            {"letter", "name", "title", "drive", "frames", "footprint", "height", "limits",
                             "sensors", "streams", "bindings", "link_loss"},
                            errors);
    RobotDescription robot;
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.height = 0.5;
    robot.maxRoll = robot.maxPitch = degrees(25);
    robot.maxSpeed = 0.3;
    robot.maxTurnRate = degrees(30);
    if (!root.IsMap()) return robot;
    readIdentity(fields, robot);
    fields.choice("drive", robot.drive, detail::driveWords());
    if (fields.has("frames")) readFrames(root["frames"], robot, errors);
    readFootprint(fields, robot, errors);
    if (!fields.has("footprint")) robot.footprint = {{0.25, 0.2}, {-0.25, 0.2}, {-0.25, -0.2}, {0.25, -0.2}};
    fields.number("height", robot.height, 0.0, LargestSize);
    if (fields.has("limits")) readLimits(root["limits"], robot, errors);
    fields.each("sensors", true,
                [&](const YAML::Node& node, const std::string& name, const std::string& path) {
                    readSensor(node, name, path, robot, errors);
                });
    fields.each("streams", false, [&](const YAML::Node& node, const std::string&, const std::string& path) {
        readStream(node, path, robot, errors);
    });
    fields.each("bindings", true,
                [&](const YAML::Node& node, const std::string& action, const std::string& path) {
                    if (!node.IsScalar())
                        return errors.add(node, path, "expected the name of a key or pad control");
                    robot.bindings.emplace(action, node.Scalar());
                });
    fields.each(
        "link_loss", true, [&](const YAML::Node& node, const std::string& mode, const std::string& path) {
            const std::string word = node.IsScalar() ? node.Scalar() : std::string();
            for (const auto& [name, rule] : detail::linkLossWords()) {
                if (name == word) {
                    robot.linkLoss.emplace(mode, rule);
                    return;
                }
            }
            errors.add(node, path, "expected stop, finish_and_wait or return_to_link, found \"" + word + '"');
        });
    return robot;
}

}  // namespace

Result<RobotDescription> parseRobot(std::string_view text, const std::string& name) {
    const auto root = detail::loadYaml(text, name);
    if (!root) return root.error();
    YamlErrors errors{name, {}};
    try {
        RobotDescription robot = readAll(*root, errors);
        if (errors.texts.empty()) return robot;
    } catch (const YAML::Exception& problem) {
        errors.texts.push_back(fmt::format("{}:{}: {}", name, problem.mark.line + 1, problem.msg));
    }
    return Error{fmt::format("{}", fmt::join(errors.texts, "\n"))};
}

Result<RobotDescription> readRobot(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file)) return Error{file.string() + ": cannot be opened"};
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseRobot(text, file.string());
}

}  // namespace leitstand
