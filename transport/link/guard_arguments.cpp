#include "transport/link/guard_arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr int LastDomain = 232;

std::string hexOf(const Sender& sender) {
    std::string text;
    for (const std::uint8_t byte : sender.bytes) text += fmt::format("{:02x}", byte);
    return text;
}

template <class Number>
std::optional<Number> numberIn(std::string_view text, int base = 10) {
    Number number = {};
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number, base);
    return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

bool setSender(Sender& sender, std::string_view text) {
    if (text.size() != 2 * sender.bytes.size()) return false;
    for (std::size_t i = 0; i < sender.bytes.size(); ++i) {
        const auto byte = numberIn<std::uint8_t>(text.substr(2 * i, 2), 16);
        if (!byte) return false;
        sender.bytes[i] = *byte;
    }
    return true;
}

bool setDomain(int& domain, std::string_view text) {
    const auto number = numberIn<int>(text);
    if (number) domain = *number;
    return number && domain >= 0 && domain <= LastDomain;
}

/// Sets a number that is finite and not below zero; false for any other text.
bool setLength(double& length, std::string_view text) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    length = number;
    return read.ec == std::errc() && read.ptr == end && std::isfinite(number) && number >= 0.0;
}

bool setText(std::string& to, std::string_view text) {
    to = text;
    return !text.empty();
}

bool add(std::vector<std::string>& to, std::string_view text) {
    to.emplace_back(text);
    return !text.empty();
}

std::string toString(Qos::Reliability reliability) {
    return reliability == Qos::Reliability::Reliable ? "reliable" : "best_effort";
}

template <class Kind>
bool setKind(Kind& to, std::string_view text, std::initializer_list<Kind> kinds) {
    for (const Kind kind : kinds) {
        if (toString(kind) != text) continue;
        to = kind;
        return true;
    }
    return false;
}

/// An option, what it expects, and its setter, which returns false for a text that does not fit.
struct Option {
    const char* name;
    const char* expects;
    bool (*set)(GuardArguments& arguments, std::string_view text);
};

constexpr std::array<Option, 18> Options = {{
    {"--domain", "DDS domain, 0 to 232",
     [](GuardArguments& all, std::string_view text) { return setDomain(all.network.domain, text); }},
    {"--interface", "a network interface; may come again",
     [](GuardArguments& all, std::string_view text) { return add(all.network.interfaces, text); }},
    {"--peer", "an address; may come again",
     [](GuardArguments& all, std::string_view text) { return add(all.network.initialPeers, text); }},
    {"--multicast", "on or off",
     [](GuardArguments& all, std::string_view text) {
         all.network.multicast = text != "off";
         return text == "on" || text == "off";
     }},
    {"--discovery-server", "as in ROS_DISCOVERY_SERVER",
     [](GuardArguments& all, std::string_view text) { return setText(all.network.discoveryServer, text); }},
    {"--keys", "folder of the station's identity",
     [](GuardArguments& all, std::string_view text) {
         all.keys = text;
         return !text.empty();
     }},
    {"--robot", "the robot's name",
     [](GuardArguments& all, std::string_view text) { return setText(all.guard.robot, text); }},
    {"--station", "the station's identity",
     [](GuardArguments& all, std::string_view text) { return setText(all.guard.station, text); }},
    {"--driver", "24 hexadecimal digits: the station's participant",
     [](GuardArguments& all, std::string_view text) { return setSender(all.guard.driver, text); }},
    {"--role", "drive_command or track_command",
     [](GuardArguments& all, std::string_view text) {
         return setKind(all.guard.message.stream.role, text,
                        {StreamRole::DriveCommand, StreamRole::TrackCommand});
     }},
    {"--topic", "the topic of its drive commands",
     [](GuardArguments& all, std::string_view text) {
         return setText(all.guard.message.stream.topic, text);
     }},
    {"--type", "their ROS type",
     [](GuardArguments& all, std::string_view text) { return setText(all.guard.message.stream.type, text); }},
    {"--reliability", "reliable or best_effort",
     [](GuardArguments& all, std::string_view text) {
         return setKind(all.guard.message.stream.qos.reliability, text,
                        {Qos::Reliability::Reliable, Qos::Reliability::BestEffort});
     }},
    {"--lifespan", "of a command [s]; 0: for ever",
     [](GuardArguments& all, std::string_view text) {
         return setLength(all.guard.message.stream.qos.lifespan, text);
     }},
    {"--stamp", "robot, zero or station",
     [](GuardArguments& all, std::string_view text) {
         return setKind(all.guard.message.stream.stamp, text,
                        {StampSource::Robot, StampSource::Zero, StampSource::Station});
     }},
    {"--frame", "of stamped commands",
     [](GuardArguments& all, std::string_view text) { return setText(all.guard.message.frame, text); }},
    {"--left-track", "joint of track commands",
     [](GuardArguments& all, std::string_view text) { return setText(all.guard.message.leftTrack, text); }},
    {"--right-track", "joint of track commands",
     [](GuardArguments& all, std::string_view text) { return setText(all.guard.message.rightTrack, text); }},
}};

const Option* find(std::string_view name) {
    const auto found =
        std::find_if(Options.begin(), Options.end(), [name](const Option& one) { return name == one.name; });
    return found == Options.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> wordsOf(const GuardArguments& arguments) {
    std::vector<std::string> words;
    const auto addWord = [&words](const char* name, const std::string& value) {
        if (!value.empty()) words.insert(words.end(), {name, value});
    };
    const NodeSettings& network = arguments.network;
    addWord("--domain", std::to_string(network.domain));
    for (const std::string& one : network.interfaces) addWord("--interface", one);
    for (const std::string& one : network.initialPeers) addWord("--peer", one);
    if (!network.multicast) addWord("--multicast", "off");
    addWord("--discovery-server", network.discoveryServer);
    addWord("--keys", arguments.keys.string());
    const DriveGuardSettings& guard = arguments.guard;
    addWord("--robot", guard.robot);
    addWord("--station", guard.station);
    addWord("--driver", hexOf(guard.driver));
    const StreamDescription& stream = guard.message.stream;
    addWord("--role", toString(stream.role));
    addWord("--topic", stream.topic);
    addWord("--type", stream.type);
    addWord("--reliability", toString(stream.qos.reliability));
    addWord("--lifespan", fmt::format("{}", stream.qos.lifespan));
    addWord("--stamp", toString(stream.stamp));
    addWord("--frame", guard.message.frame);
    addWord("--left-track", guard.message.leftTrack);
    addWord("--right-track", guard.message.rightTrack);
    return words;
}

Result<GuardArguments> guardArgumentsFrom(const std::vector<std::string>& words) {
    GuardArguments arguments;
    arguments.guard.message.stream.role = StreamRole::DriveCommand;
    for (std::size_t i = 0; i < words.size(); i += 2) {
        const Option* const option = find(words[i]);
        if (option == nullptr) return Error{fmt::format("{}: no such option", words[i])};
        if (i + 1 == words.size() || !option->set(arguments, words[i + 1]))
            return Error{fmt::format("{}: expected {}", option->name, option->expects)};
    }
    const DriveGuardSettings& guard = arguments.guard;
    const StreamDescription& stream = guard.message.stream;
    if (guard.robot.empty() || guard.station.empty() || stream.topic.empty() || stream.type.empty())
        return Error{"expected --robot, --station, --topic and --type"};
    return arguments;
}

std::string guardHelp() {
    std::string text =
        "leitstand-guard: sends zero commands for two seconds to a robot without a watchdog when the "
        "station\n"
        "that drives it says nothing more through its pipe for 0.2 s, or is gone. It sends nothing beside\n"
        "somebody else who drives. The station starts it by itself; by hand it ends at once.\n\nOptions:\n";
    for (const Option& one : Options) text += fmt::format("  {:<20}{}\n", one.name, one.expects);
    return text;
}

}  // namespace leitstand
