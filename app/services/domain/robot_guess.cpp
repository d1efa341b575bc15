#include "app/services/domain/robot_guess.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "core/event/station_topics.h"
#include "core/robot/streams/stream_defaults.h"
#include "transport/convert/message_catalog.h"

namespace leitstand {
namespace {

/// Last part of a name: "/kurt3d/odom" -> "odom".
std::string_view leafOf(std::string_view name) {
    return name.substr(name.rfind('/') + 1);
}

/// First part of a name of several: "/kurt3d/odom" -> "kurt3d"; empty for "/odom".
std::string namespaceOf(std::string_view name) {
    if (name.empty() || name.front() != '/') return {};
    const auto end = name.find('/', 1);
    return end == std::string_view::npos ? std::string() : std::string(name.substr(1, end - 1));
}

bool hasPart(std::string_view name, std::initializer_list<std::string_view> words) {
    for (std::size_t begin = 0; begin <= name.size();) {
        const auto end = std::min(name.find_first_of("/_", begin), name.size());
        const std::string_view part = name.substr(begin, end - begin);
        if (std::find(words.begin(), words.end(), part) != words.end()) return true;
        begin = end + 1;
    }
    return false;
}

/// Types that a robot says, and their roles.
const std::map<std::string_view, StreamRole>& rolesOfTypes() {
    static const std::map<std::string_view, StreamRole> roles = {
        {"sensor_msgs/msg/PointCloud2", StreamRole::Points},
        {"sensor_msgs/msg/LaserScan", StreamRole::Ranges},
        {"nav_msgs/msg/Odometry", StreamRole::Odometry},
        {"sensor_msgs/msg/Imu", StreamRole::Imu},
        {"sensor_msgs/msg/JointState", StreamRole::Joints},
        {"tf2_msgs/msg/TFMessage", StreamRole::Transforms},
        {"sensor_msgs/msg/Image", StreamRole::Picture},
        {"sensor_msgs/msg/CompressedImage", StreamRole::Picture},
        {"sensor_msgs/msg/CameraInfo", StreamRole::CameraInfo},
        {"leitstand_msgs/msg/GasConcentration", StreamRole::Gas},
        {"sensor_msgs/msg/BatteryState", StreamRole::Battery},
        {"diagnostic_msgs/msg/DiagnosticArray", StreamRole::Diagnostics},
    };
    return roles;
}

/// Names of the robot's own topics of leitstand_msgs, and of what it listens to (design, section 4).
const std::map<std::string_view, StreamRole>& rolesOfNames() {
    static const std::map<std::string_view, StreamRole> roles = {
        {"mode", StreamRole::Mode},
        {"bumps", StreamRole::Bumps},
        {"sightings", StreamRole::Sightings},
        {"stop_state", StreamRole::StopState},
        {"pong", StreamRole::Pong},
        {"stop_cmd", StreamRole::StopCommand},
        {"mode_cmd", StreamRole::ModeCommand},
        {"stream_cmd", StreamRole::StreamCommand},
        {"ping", StreamRole::Ping},
    };
    return roles;
}

std::optional<StreamRole> commandRole(const SeenTopic& topic) {
    const std::string_view leaf = leafOf(topic.name);
    if (topic.type == "geometry_msgs/msg/Twist" || topic.type == "geometry_msgs/msg/TwistStamped") {
        if (hasPart(leaf, {"cmd", "command"})) return StreamRole::DriveCommand;
    } else if (topic.type == "geometry_msgs/msg/PoseStamped" && hasPart(leaf, {"goal"})) {
        return StreamRole::GoalPose;
    } else if (topic.type == "sensor_msgs/msg/JointState") {
        if (leaf == "track_cmd") return StreamRole::TrackCommand;
        if (leaf == "ptu_cmd") return StreamRole::PanTiltCommand;
    }
    return std::nullopt;
}

/// Camera or sensor that a picture topic belongs to: "/kurt3d/left/image/compressed" -> "left".
std::string sensorOf(const std::string& name, const std::string& robot) {
    std::string_view rest = name;
    if (!robot.empty() && namespaceOf(name) == robot) rest.remove_prefix(robot.size() + 1);
    const std::string first = namespaceOf(rest);
    return first.empty() ? std::string("camera") : first;
}

/// Whether topics of this name tell that their namespace is a robot's.
bool tellsARobot(std::string_view leaf) {
    static const std::set<std::string_view> leaves = {
        "odom", "cmd_vel",      "scan",          "points",     "tf",
        "imu",  "joint_states", "battery_state", "stop_state", "mode"};
    return leaves.contains(leaf);
}

std::string letterFor(const std::string& name, std::set<std::string>& taken) {
    std::string letters;
    for (const char c : name + "ABCDEFGHIJKLMNOPQRSTUVWXYZ") {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            letters += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        }
    }
    const auto free = std::find_if(letters.begin(), letters.end(),
                                   [&](char letter) { return !taken.contains(std::string(1, letter)); });
    const std::string letter(1, free == letters.end() ? 'R' : *free);
    taken.insert(letter);
    return letter;
}

void addTopic(RobotGuess& guess, const SeenTopic& topic) {
    TopicVerdict verdict{.topic = topic, .role = {}, .remark = {}};
    verdict.role = roleOf(topic, verdict.remark);
    if (verdict.role) {
        StreamDescription stream{.role = *verdict.role,
                                 .sensor = {},
                                 .topic = topic.name,
                                 .type = topic.type,
                                 .qos = topic.qos,
                                 .thermal = {},
                                 .hardwareId = {}};
        const bool picture = *verdict.role == StreamRole::Picture || *verdict.role == StreamRole::Thermal ||
                             *verdict.role == StreamRole::CameraInfo;
        if (picture) stream.sensor = sensorOf(topic.name, guess.robot.name);
        // DDS does not tell how deep a history is.
        stream.qos.depth = defaultStream(stream.role, guess.robot.name, stream.sensor).qos.depth;
        const bool again =
            !picture && *verdict.role != StreamRole::Points && guess.robot.stream(*verdict.role) != nullptr;
        if (again) {
            verdict.remark = fmt::format("a second topic of this kind; the first one is used ({})",
                                         guess.robot.stream(*verdict.role)->topic);
        } else {
            guess.robot.streams.push_back(stream);
        }
    }
    guess.topics.push_back(std::move(verdict));
}

RobotGuess named(const std::string& name, bool prefixed, std::set<std::string>& letters) {
    RobotGuess guess;
    guess.robot.name = name;
    guess.robot.title = name;
    guess.robot.title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    guess.robot.letter = letterFor(name, letters);
    guess.robot.baseFrame = "base_link";
    guess.robot.odomFrame = "odom";
    guess.robot.tfPrefix = prefixed ? TfPrefix::Topic : TfPrefix::None;
    return guess;
}

/// Whether @p robot says on a topic of its own what all say on @p topic.
bool hasOwn(const std::string& robot, const std::string& topic, const std::vector<SeenTopic>& topics) {
    return std::any_of(topics.begin(), topics.end(),
                       [own = "/" + robot + topic](const SeenTopic& one) { return one.name == own; });
}

}  // namespace

std::optional<StreamRole> roleOf(const SeenTopic& topic, std::string& remark) {
    if (!topic.obstacle.empty()) {
        remark = topic.obstacle;
        return std::nullopt;
    }
    const std::string_view name = topic.name, leaf = leafOf(name);
    if (name.starts_with("rq/") || name.starts_with("rr/") ||
        name.find("/_action/") != std::string_view::npos) {
        remark = "a service or an action: the station uses topics only";
        return std::nullopt;
    }
    if (!name.starts_with('/')) {
        remark = "not a topic of ROS 2";
        return std::nullopt;
    }
    if (const auto command = commandRole(topic)) {
        if (!topic.read) remark = "nobody listens to it";
        return command;
    }
    if (topic.type.starts_with("leitstand_msgs/")) {
        if (const auto role = rolesOfNames().find(leaf); role != rolesOfNames().end()) return role->second;
    }
    if (!topic.written) {
        remark = "nobody publishes it, and the station has nothing to say there";
        return std::nullopt;
    }
    if (topic.type == "std_msgs/msg/Float32" && hasPart(name, {"co2", "gas"})) return StreamRole::Gas;
    if (leaf == "compressedDepth" || leaf == "theora" || leaf == "zstd") {
        remark = fmt::format(
            "pictures of the transport \"{}\" are not understood, expected raw or compressed", leaf);
        return std::nullopt;
    }
    const auto role = rolesOfTypes().find(topic.type);
    if (role == rolesOfTypes().end()) {
        remark = findMessageType(topic.type) != nullptr
                     ? "nothing in the station shows it"
                     : fmt::format("type {} is not known: it can be recorded, not shown", topic.type);
        return std::nullopt;
    }
    if (role->second == StreamRole::Transforms && leaf == "tf_static") return StreamRole::StaticTransforms;
    if (role->second == StreamRole::Picture && hasPart(name, {"ir", "thermal", "lepton", "flir"})) {
        remark = "taken as infrared: check scale and offset in the robot's file";
        return StreamRole::Thermal;
    }
    return role->second;
}

std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics) {
    std::set<std::string> names, letters;
    for (const SeenTopic& topic : topics) {
        const std::string space = namespaceOf(topic.name);
        const bool direct = !space.empty() && topic.name.size() > space.size() + 2 &&
                            topic.name.find('/', space.size() + 2) == std::string::npos;
        if (direct && space != "leitstand" && tellsARobot(leafOf(topic.name))) names.insert(space);
    }
    const bool prefixed = !names.empty();
    std::string rest = names.size() == 1 ? *names.begin() : std::string();
    if (names.empty()) names.insert(rest = "robot");
    std::map<std::string, RobotGuess> guesses;
    for (const std::string& name : names) guesses.emplace(name, named(name, prefixed, letters));
    for (const SeenTopic& topic : topics) {
        if (topic.name.starts_with(station_topic::Prefix)) continue;
        const auto own = guesses.find(namespaceOf(topic.name));
        if (own != guesses.end()) {
            addTopic(own->second, topic);
        } else if (!rest.empty()) {
            addTopic(guesses.at(rest), topic);
        } else if (topic.name == "/tf" || topic.name == "/tf_static" || topic.name == "/diagnostics") {
            for (auto& [name, guess] : guesses) {
                // Of a tree that all share, a robot has the frames with its name; where it has a tree of its
                // own, that.
                const bool tree = topic.name != "/diagnostics";
                if (tree && hasOwn(name, topic.name, topics)) continue;
                if (tree) guess.robot.tfPrefix = TfPrefix::Frame;
                addTopic(guess, topic);
            }
        }
    }
    std::vector<RobotGuess> result;
    for (auto& [name, guess] : guesses) {
        for (StreamDescription& stream : guess.robot.streams) {
            // Robots with names share it with others that are here, or will be.
            if (prefixed && stream.topic == "/diagnostics") stream.hardwareId = name;
        }
        if (!guess.topics.empty()) result.push_back(std::move(guess));
    }
    return result;
}

}  // namespace leitstand
