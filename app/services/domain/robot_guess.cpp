#include "app/services/domain/robot_guess.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/services/domain/robot_spaces.h"
#include "app/services/domain/service_guess.h"
#include "app/services/domain/topic_role.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"
#include "transport/services/service_messages.h"

namespace leitstand {
namespace {

/// Endings of a camera's topics, below its name.
constexpr std::array<std::string_view, 16> OfPictures = {
    "image", "image_raw",  "image_rect", "image_rect_raw", "image_color",     "image_mono", "ffmpeg",
    "h264",  "compressed", "raw",        "theora",         "compressedDepth", "zstd",       "camera_info",
    "h265",  "video"};

/// Camera that a topic belongs to: "/kurt3d/left/image/compressed" -> "left".
std::string sensorOf(const std::string& name, const std::string& space) {
    std::string_view rest = name;
    if (!space.empty() && namespaceOf(name) == space) rest.remove_prefix(space.size() + 1);
    while (!rest.empty() && std::find(OfPictures.begin(), OfPictures.end(), leafOf(rest)) != OfPictures.end())
        rest = rest.substr(0, rest.rfind('/'));
    std::string sensor(rest.substr(rest.empty() ? 0 : 1));
    std::replace(sensor.begin(), sensor.end(), '/', '_');
    return sensor.empty() ? "camera" : sensor;
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
    std::string letter(1, free == letters.end() ? 'R' : *free);
    taken.insert(letter);
    return letter;
}

/// The stream of @p robot that @p topic would be a second one of; null: it is the first of its kind.
StreamDescription* sameAs(const StreamDescription& stream, RobotDescription& robot) {
    const StreamFacts& facts = streamFacts(stream.role);
    const bool ofCamera = facts.ofCamera || isDepthStream(stream);
    if (facts.several && !ofCamera) return nullptr;
    const auto same = std::find_if(robot.streams.begin(), robot.streams.end(), [&](const auto& one) {
        return one.role == stream.role && (!ofCamera || one.sensor == stream.sensor);
    });
    return same == robot.streams.end() ? nullptr : &*same;
}

StreamDescription streamOf(const SeenTopic& topic, StreamRole role, const RobotGuess& guess,
                           const std::string& space) {
    StreamDescription stream{.role = role,
                             .sensor = {},
                             .topic = topic.name,
                             .type = topic.type,
                             .qos = topic.qos,
                             .group = {},
                             .thermal = {},
                             .hardwareId = {}};
    if (role == StreamRole::Reading) stream.readings = usualReadings(topic.type);
    const StreamFacts& facts = streamFacts(role);
    const bool pictures = facts.picture || isDepthStream(stream);
    if (facts.ofCamera || pictures) stream.sensor = sensorOf(topic.name, space);
    // DDS does not announce the depth of a history.
    const Qos usual = defaultStream(role, guess.robot.name, stream.sensor).qos;
    stream.qos.depth = usual.depth;
    // Nor how long a command of ours counts: an old one must not drive the robot.
    if (isCommand(role)) stream.qos.lifespan = usual.lifespan;
    // On a radio link the next picture is better than the same again.
    if (pictures) stream.qos.reliability = Qos::Reliability::BestEffort;
    if (isDepthStream(stream)) stream.qos.depth = streamFacts(StreamRole::Picture).qos.depth;
    return stream;
}

/// How well pictures of @p type suit a radio link: those of a video need the least, raw ones the most.
int thriftOf(std::string_view type) {
    if (type == "sensor_msgs/msg/Image") return 0;
    return type == "sensor_msgs/msg/CompressedImage" ? 1 : 2;
}

TopicVerdict* verdictOn(const std::string& topic, RobotGuess& guess) {
    const auto found = std::find_if(guess.topics.begin(), guess.topics.end(),
                                    [&](const TopicVerdict& one) { return one.topic.name == topic; });
    return found == guess.topics.end() ? nullptr : &*found;
}

/// @p space: the robot's namespace.
void addTopic(RobotGuess& guess, const SeenTopic& topic, const std::string& space) {
    constexpr const char* Smaller = "the same pictures come compressed: {} is used";
    constexpr const char* AsVideo = "the same pictures come as a video: {} is used";
    const auto smaller = [&](const StreamDescription& used) {
        return fmt::format(fmt::runtime(thriftOf(used.type) > 1 ? AsVideo : Smaller), used.topic);
    };
    TopicVerdict verdict{.topic = topic, .role = {}, .remark = {}};
    if (const auto service = guessService(topic)) {
        guess.robot.services.push_back(*service);
        verdict.remark = "a service or an action that the station calls";
        guess.topics.push_back(std::move(verdict));
        return;
    }
    verdict.role = roleOf(topic, verdict.remark);
    if (verdict.role) {
        const StreamDescription stream = streamOf(topic, *verdict.role, guess, space);
        StreamDescription* const same = sameAs(stream, guess.robot);
        // Compressed infrared pictures may have lost their temperatures.
        const bool picture = stream.role == StreamRole::Picture;
        if (same == nullptr) {
            guess.robot.streams.push_back(stream);
        } else if (picture && thriftOf(stream.type) > thriftOf(same->type)) {
            if (TopicVerdict* const before = verdictOn(same->topic, guess)) {
                before->role.reset();
                before->remark = smaller(stream);
            }
            *same = stream;
        } else {
            verdict.role.reset();
            verdict.remark =
                picture && thriftOf(same->type) > thriftOf(stream.type)
                    ? smaller(*same)
                    : fmt::format("a second topic of this kind; the first one is used ({})", same->topic);
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

/// Takes depth pictures of a robot without any other scanner: of each camera the compressed ones, if there
/// are any.
void addDepths(RobotGuess& guess, const std::string& space) {
    const bool scans = guess.robot.stream(StreamRole::Points) != nullptr ||
                       guess.robot.stream(StreamRole::Ranges) != nullptr;
    if (scans) return;
    for (TopicVerdict& verdict : guess.topics) {
        if (!isOfDepths(verdict.topic) || !verdict.topic.written || !verdict.topic.obstacle.empty()) continue;
        const StreamDescription stream = streamOf(verdict.topic, StreamRole::Points, guess, space);
        StreamDescription* const same = sameAs(stream, guess.robot);
        if (same != nullptr && thriftOf(same->type) >= thriftOf(stream.type)) continue;
        verdict.role = StreamRole::Points;
        verdict.remark.clear();
        if (same == nullptr) {
            guess.robot.streams.push_back(stream);
            continue;
        }
        if (TopicVerdict* const before = verdictOn(same->topic, guess)) before->role.reset();
        *same = stream;
    }
}

/// Leaves out what is said of cameras whose pictures the station does not use, as of depths.
void leaveOutBlindCameras(RobotGuess& guess) {
    std::vector<StreamDescription>& streams = guess.robot.streams;
    const auto isBlind = [&](const StreamDescription& stream) {
        return stream.role == StreamRole::CameraInfo &&
               std::none_of(streams.begin(), streams.end(), [&](const StreamDescription& other) {
                   const bool seeing = streamFacts(other.role).picture || isDepthStream(other);
                   return seeing && other.sensor == stream.sensor;
               });
    };
    std::vector<StreamDescription> seeing;
    for (const StreamDescription& stream : streams) {
        if (!isBlind(stream)) {
            seeing.push_back(stream);
            continue;
        }
        for (TopicVerdict& verdict : guess.topics) {
            if (verdict.topic.name != stream.topic) continue;
            verdict.role.reset();
            verdict.remark = "of a camera whose pictures the station does not use";
        }
    }
    streams = std::move(seeing);
    std::erase_if(guess.robot.sensors, [&](const auto& sensor) {
        return std::none_of(streams.begin(), streams.end(),
                            [&](const StreamDescription& stream) { return stream.sensor == sensor.first; });
    });
}

/// Takes footprint and height from the robot's model, if its simple shapes show all of it.
void takeBody(RobotGuess& guess) {
    for (TopicVerdict& verdict : guess.topics) {
        if (verdict.role != StreamRole::Model || !verdict.topic.model) continue;
        const Result<BodyExtent>& extent = *verdict.topic.model;
        if (!extent) {
            verdict.remark = extent.error().text;
            continue;
        }
        guess.robot.footprint = extent->footprint;
        guess.robot.height = extent->height;
        verdict.remark = "footprint and height are taken from it: measure them all the same";
    }
}

/// Leaves out what cancels the goals of an action that is there itself.
void leaveOutCancels(std::vector<ServiceDescription>& services) {
    const std::vector<ServiceDescription> all = services;
    std::erase_if(services, [&](const ServiceDescription& one) {
        return std::any_of(all.begin(), all.end(), [&](const ServiceDescription& action) {
            return one.name == action.name + "/_action/cancel_goal";
        });
    });
}

}  // namespace

std::vector<RobotGuess> guessRobots(const std::vector<SeenTopic>& topics) {
    const std::set<std::string> spaces = robotSpaces(topics);
    std::set<std::string> letters;
    std::map<std::string, RobotGuess> guesses;
    for (const std::string& space : spaces)
        guesses.emplace(space, named(space.empty() ? "robot" : space, !space.empty(), letters));
    RobotGuess* const rest = spaces.contains("")  ? &guesses.at("")
                             : spaces.size() == 1 ? &guesses.begin()->second
                                                  : nullptr;
    for (const SeenTopic& topic : topics) {
        if (topic.name.starts_with(station_topic::Prefix)) continue;
        // A service has the namespace of its own name, not of its DDS topic.
        SeenTopic placed = topic;
        if (const std::string service = serviceOf(topic.name); !service.empty()) placed.name = service;
        const auto own = guesses.find(spaceOf(placed));
        const bool tree = topic.name == "/tf" || topic.name == "/tf_static";
        if (tree || topic.name == "/diagnostics") {
            for (auto& [space, guess] : guesses) {
                // Of a tree that all share, a robot has the frames with its name. A robot with its own tree
                // uses that instead.
                if (tree && hasOwn(space, topic.name, topics)) continue;
                if (tree && guesses.size() > 1 && !space.empty()) guess.robot.tfPrefix = TfPrefix::Frame;
                addTopic(guess, topic, space);
            }
        } else if (own != guesses.end()) {
            addTopic(own->second, topic, own->first);
        } else if (rest != nullptr) {
            addTopic(*rest, topic, spaces.contains("") ? std::string() : *spaces.begin());
        }
    }
    std::vector<RobotGuess> result;
    for (auto& [space, guess] : guesses) {
        leaveOutCancels(guess.robot.services);
        for (StreamDescription& stream : guess.robot.streams) {
            // Named robots share it with others that are here, or will be.
            if (!space.empty() && stream.topic == "/diagnostics") stream.hardwareId = space;
        }
        addDepths(guess, space);
        leaveOutBlindCameras(guess);
        distinguishReadings(guess.robot);
        takeBody(guess);
        if (!guess.topics.empty()) result.push_back(std::move(guess));
    }
    return result;
}

}  // namespace leitstand
