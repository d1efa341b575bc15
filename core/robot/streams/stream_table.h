#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/robot/streams/qos.h"

namespace leitstand {

enum class StreamRole : std::uint8_t;

/// Order in which a thin link gives streams up: the last rank first (thinRequests()).
enum class ThinRank : std::uint8_t { Kept, Telemetry, Scans, Pictures };

/// What a thinned mission keeps of a stream (ThinSettings of thinMission()).
enum class ThinnedAs : std::uint8_t { Kept, Cloud, Ranges, Picture, Motion, Other };

/// How the role of a topic is guessed when no robot's file names the topic.
enum class GuessedBy : std::uint8_t {
    /// Its type is the first of StreamFacts::types. Another one of them also counts, if words is empty or a
    /// part of the name is one of the words.
    Type,
    Name,   ///< its name ends with StreamFacts::topic, and its type is one of StreamFacts::types
    Words,  ///< a part of its name is one of StreamFacts::words, and its type is one of types
};

/// Whether a stream shows what stands around the robot, and so goes into the virtual scan (RobotSight).
enum class Sight : std::uint8_t {
    None,
    Distances,  ///< single distances, as of a sonar: nobody drives by them
    Scanner,    ///< all around or ahead: a driver may drive by it, and mapping or reviews may wait for it
};

/// Properties of the streams of one role.
struct StreamFacts {
    StreamRole role{};
    const char* title = nullptr;  ///< for operators, translated in StreamTitles; null: the role's name
    std::span<const std::string_view> types;  ///< ROS types that it may have, the usual one first
    std::string_view topic;                   ///< usual name, below the robot's name; absolute with a slash
    Qos qos;                                  ///< usual QoS
    bool ofCamera = false;                    ///< its topic lies below the name of its camera
    bool picture = false;
    bool single = false;    ///< a robot has at most one: with two, it is unclear which to obey or believe
    bool shared = false;    ///< robots may share one topic for this role
    bool steady = false;    ///< sent periodically; others only on a change or a request
    bool quick = false;     ///< steady, and sent several times a second
    bool alwaysOn = false;  ///< steady, and no robot switches it off
    bool needed = false;    ///< must be received in the preflight check, if the robot has it
    bool several = false;   ///< a guessed robot may have more than one; of cameras, one for each
    Sight sight = Sight::None;
    bool indexed = false;  ///< a review reads all of it when it opens the mission
    /// Rank of its stamps for estimating the robot's clock (LinkMonitor); lower is better. Streams of low
    /// rank are written at once, by the computer whose clock matters most.
    int stampRank = 6;
    ThinRank thinRank = ThinRank::Kept;
    double usualRate = 1.0;        ///< [Hz]
    double usualMegabits = 0.005;  ///< [Mbit/s]
    ThinnedAs thinnedAs = ThinnedAs::Kept;
    std::string_view inLog = {};  ///< name of the stream in sentences of the log; empty: the role's name
    GuessedBy guessedBy = GuessedBy::Type;
    std::span<const std::string_view> words = {};
};

inline constexpr const char* StreamTitles = "leitstand::LinkStatus";  ///< translation context

/// A row for each role, by rising number.
[[nodiscard]] std::span<const StreamFacts> streamTable();
[[nodiscard]] const StreamFacts& streamFacts(StreamRole role);
[[nodiscard]] bool isScanner(StreamRole role);  ///< whether its Sight is Scanner

/// The ROS types that a stream of @p role may have; the first one is the usual one.
[[nodiscard]] std::span<const std::string_view> typesOf(StreamRole role);

}  // namespace leitstand
