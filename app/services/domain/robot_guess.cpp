#include "app/services/domain/robot_guess.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/message_catalog.h"

namespace leitstand {
namespace {

/// Last part of a name: "/kurt3d/odom" -> "odom".
std::string_view leafOf(std::string_view name) {
    return name.substr(name.rfind('/') + 1);
}

/// First part of a name with several: "/kurt3d/odom" -> "kurt3d"; empty for "/odom".
std::string namespaceOf(std::string_view name) {
    if (name.empty() || name.front() != '/') return {};
    const auto end = name.find('/', 1);
    return end == std::string_view::npos ? std::string() : std::string(name.substr(1, end - 1));
}

/// Whether a part of @p name is one of @p words.
bool hasPart(std::string_view name, std::span<const std::string_view> words) {
    for (std::size_t begin = 0; begin <= name.size();) {
        const auto end = std::min(name.find_first_of("/_", begin), name.size());
        const std::string_view part = name.substr(begin, end - begin);
        if (std::find(words.begin(), words.end(), part) != words.end()) return true;
        begin = end + 1;
    }
    return false;
}

/// Whether @p topic, whose type @p row has, matches the row by name, words or type.
bool isGuessedBy(const StreamFacts& row, const SeenTopic& topic) {
    const std::string_view leaf = leafOf(topic.name);
    switch (row.guessedBy) {
        case GuessedBy::Name:
            return leaf == row.topic;
        case GuessedBy::Words:
            return hasPart(isCommand(row.role) ? leaf : std::string_view(topic.name), row.words);
        case GuessedBy::Type:
            break;
    }
    return row.words.empty() || topic.type == row.types.front() || hasPart(topic.name, row.words);
}

/// Returns the role of @p topic in the table of streams, among commands or among what robots publish. A match
/// by name goes before a match by type.
std::optional<StreamRole> roleInTable(const SeenTopic& topic, bool commands) {
    const StreamFacts* found = nullptr;
    for (const StreamFacts& row : streamTable()) {
        const bool known = std::find(row.types.begin(), row.types.end(), topic.type) != row.types.end();
        if (isCommand(row.role) != commands || !known || !isGuessedBy(row, topic)) continue;
        if (found == nullptr || (found->guessedBy == GuessedBy::Type && row.guessedBy != GuessedBy::Type))
            found = &row;
    }
    return found == nullptr ? std::nullopt : std::optional(found->role);
}

/// Camera or sensor that a picture topic belongs to: "/kurt3d/left/image/compressed" -> "left".
std::string sensorOf(const std::string& name, const std::string& robot) {
    std::string_view rest = name;
    if (!robot.empty() && namespaceOf(name) == robot) rest.remove_prefix(robot.size() + 1);
    const std::string first = namespaceOf(rest);
    return first.empty() ? std::string("camera") : first;
}

/// Whether topics of this name mark their namespace as a robot's.
bool namesARobot(std::string_view leaf) {
    const auto table = streamTable();
    return std::any_of(table.begin(), table.end(),
                       [leaf](const StreamFacts& row) { return row.namesRobot && row.topic == leaf; });
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
        const bool picture = streamFacts(*verdict.role).ofCamera;
        if (picture) stream.sensor = sensorOf(topic.name, guess.robot.name);
        // DDS does not announce the depth of a history.
        stream.qos.depth = defaultStream(stream.role, guess.robot.name, stream.sensor).qos.depth;
        const bool again = !picture && !streamFacts(*verdict.role).several &&
                           guess.robot.stream(*verdict.role) != nullptr;
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

/// Whether @p robot has its own topic for what all publish on @p topic.
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
    const bool ours = topic.type.starts_with("leitstand_msgs/");
    if (const auto command = roleInTable(topic, true)) {
        if (!topic.read && !ours) remark = "nobody listens to it";
        return command;
    }
    const auto role = roleInTable(topic, false);
    if (ours && role && streamFacts(*role).guessedBy == GuessedBy::Name) return role;
    if (!topic.written) {
        remark = "nobody publishes it, and the station has nothing to say there";
        return std::nullopt;
    }
    if (leaf == "compressedDepth" || leaf == "theora" || leaf == "zstd") {
        remark = fmt::format(
            "pictures of the transport \"{}\" are not understood, expected raw or compressed", leaf);
        return std::nullopt;
    }
    if (!role) {
        remark = findMessageType(topic.type) != nullptr
                     ? "nothing in the station shows it"
                     : fmt::format("type {} is not known: it can be recorded, not shown", topic.type);
        return std::nullopt;
    }
    if (*role == StreamRole::Thermal)
        remark = "taken as infrared: check scale and offset in the robot's file";
    return role;
}

std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics) {
    std::set<std::string> names, letters;
    for (const SeenTopic& topic : topics) {
        const std::string space = namespaceOf(topic.name);
        const bool direct = !space.empty() && topic.name.size() > space.size() + 2 &&
                            topic.name.find('/', space.size() + 2) == std::string::npos;
        if (direct && space != "leitstand" && namesARobot(leafOf(topic.name))) names.insert(space);
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
                // Of a tree that all share, a robot has the frames with its name. A robot with its own tree
                // uses that instead.
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
            // Named robots share it with others that are here, or will be.
            if (prefixed && stream.topic == "/diagnostics") stream.hardwareId = name;
        }
        if (!guess.topics.empty()) result.push_back(std::move(guess));
    }
    return result;
}

}  // namespace leitstand
