#include "app/services/log/replay/replay_rules.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/event/station_topics.h"

namespace leitstand {
namespace {

bool isCommandWord(std::string_view word) {
    constexpr std::array<std::string_view, 12> Words = {"cmd",      "cmds", "command", "commands",
                                                        "goal",     "stop", "ping",    "teleop",
                                                        "setpoint", "lock", "locks",   "pause"};
    return std::find(Words.begin(), Words.end(), word) != Words.end();
}

bool namesACommand(std::string_view topic) {
    const std::string_view leaf = topic.substr(topic.rfind('/') + 1);
    if (leaf == "stop_state") return false;  // the robot's own report
    for (std::size_t begin = 0; begin <= topic.size();) {
        const auto end = std::min(topic.find_first_of("/_", begin), topic.size());
        std::string word(topic.substr(begin, end - begin));
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (isCommandWord(word)) return true;
        begin = end + 1;
    }
    return false;
}

bool isCommandType(std::string_view type) {
    constexpr std::array<std::string_view, 3> Types = {"geometry_msgs/msg/Twist",
                                                       "geometry_msgs/msg/TwistStamped",
                                                       "ackermann_msgs/msg/AckermannDriveStamped"};
    if (std::find(Types.begin(), Types.end(), type) != Types.end()) return true;
    return type.starts_with("leitstand_msgs/msg/") &&
           (type.ends_with("Command") || type.ends_with("/Grant") || type.ends_with("/Ping"));
}

}  // namespace

bool isReplayable(std::string_view topic, std::string_view type) {
    return !topic.starts_with(station_topic::Prefix) && topic.find("/_action/") == std::string_view::npos &&
           !namesACommand(topic) && !isCommandType(type);
}

std::string robotOfTopic(std::string_view topic) {
    if (!topic.starts_with('/')) return {};
    const auto end = topic.find('/', 1);
    return end == std::string_view::npos ? std::string() : std::string(topic.substr(1, end - 1));
}

}  // namespace leitstand
