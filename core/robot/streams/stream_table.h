#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/robot/streams/qos.h"

namespace leitstand {

enum class StreamRole : std::uint8_t;
struct StreamDescription;

/// Order in which streams are reduced on a thin link: the last rank first (thinRequests()).
enum class ThinRank : std::uint8_t { Kept, Telemetry, Scans, Pictures };

/// What a thinned mission keeps of a stream (ThinningSettings of thinMission()).
enum class ThinnedAs : std::uint8_t { Kept, Cloud, Ranges, Picture, Motion, Other };

/// How the role of a topic is guessed when no robot's file names the topic.
enum class GuessedBy : std::uint8_t {
    /// Its type is the first of StreamFacts::types. Other types in that list are accepted too, if `words` is
    /// empty or a part of the topic's name is one of the words.
    Type,
    Name,  ///< its topic's name ends with StreamFacts::topic, and its type is one of StreamFacts::types
    /// A part of its topic's name is one of StreamFacts::words, and its type is one of StreamFacts::types.
    Words,
};

/// Whether a stream shows what is around the robot, so that it is added to the virtual scan (RobotSight).
enum class Sight : std::uint8_t {
    None,
    Distances,  ///< single distances, as of a sonar: not enough to drive by
    Scanner,    ///< all around or ahead: one can drive by it, and mapping or reviews may wait for it
};

/// Properties of the streams of one role.
struct StreamFacts {
    StreamRole role{};
    /// Name for operators, translated in StreamTitles; null: the name of the role.
    const char* title = nullptr;
    std::span<const std::string_view> types;  ///< ROS types that it may have, the usual one first
    bool anyType = false;                     ///< whether a robot's file may name any other type, too
    std::string_view topic;  ///< usual name below the robot's name; absolute if it begins with a slash
    Qos qos;                 ///< usual QoS
    bool ofCamera = false;   ///< whether its topic is below the name of its camera
    bool picture = false;
    /// Whether a robot has at most one, because with two it would be unclear which to obey or believe.
    bool single = false;
    bool shared = false;    ///< whether robots may share one topic for this role
    bool steady = false;    ///< whether it is sent periodically; otherwise only on a change or a request
    bool quick = false;     ///< whether it is steady and sent several times a second
    bool alwaysOn = false;  ///< whether it is steady and no robot switches it off
    bool needed = false;    ///< whether the preflight check requires it, if the robot has it
    bool several = false;   ///< whether a guessed robot may have more than one; cameras: one each
    Sight sight = Sight::None;
    bool indexed = false;  ///< whether a review reads all of it when it opens the mission
    /// Rank of its stamps for estimating the robot's clock (LinkMonitor); lower is better. Streams with a low
    /// rank are written without delay, by the computer whose clock matters most.
    int stampRank = 6;
    ThinRank thinRank = ThinRank::Kept;
    double usualRate = 1.0;        ///< usual rate [Hz]
    double usualMegabits = 0.005;  ///< usual load [Mbit/s]
    ThinnedAs thinnedAs = ThinnedAs::Kept;
    /// Name of the stream in the sentences of the log; empty: the name of the role.
    std::string_view inLog = {};
    GuessedBy guessedBy = GuessedBy::Type;
    std::span<const std::string_view> words = {};
};

inline constexpr const char* StreamTitles = "leitstand::LinkStatus";  ///< context of translations

/// A row for each role, by rising number.
[[nodiscard]] std::span<const StreamFacts> streamTable();
[[nodiscard]] const StreamFacts& streamFacts(StreamRole role);
[[nodiscard]] bool isScanner(StreamRole role);  ///< whether the role's Sight is Scanner

/// Whether @p stream carries pictures of depths, which are scanned points.
[[nodiscard]] bool isDepthStream(const StreamDescription& stream);

/// Whether messages of the ROS type @p type hold a picture.
[[nodiscard]] bool isPictureType(std::string_view type);

/// The ROS types that a stream of @p role may have; the first one is the usual one.
[[nodiscard]] std::span<const std::string_view> typesOf(StreamRole role);

}  // namespace leitstand
