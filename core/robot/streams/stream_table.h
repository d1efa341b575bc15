#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/robot/streams/qos.h"

namespace leitstand {

enum class StreamRole : std::uint8_t;

/// What a thin link gives up, the last of these first (thinRequests()).
enum class ThinRank : std::uint8_t { Kept, Telemetry, Scans, Pictures };

/// What a thinned mission keeps of a stream (ThinSettings of thinMission()).
enum class ThinnedAs : std::uint8_t { Kept, Cloud, Ranges, Picture, Motion, Other };

/// How the role of a topic is recognised that no robot's file names.
enum class GuessedBy : std::uint8_t {
    /// Its type is the first of StreamFacts::types, or another one with one of the words, if any, in the
    /// name.
    Type,
    Name,   ///< its name ends with StreamFacts::topic, and its type is one of them
    Words,  ///< a word of its name is one of StreamFacts::words, and its type is one of them
};

/// Properties of the streams of one role.
struct StreamFacts {
    StreamRole role{};
    const char* title = nullptr;              ///< for operators, translated in StreamTitles; null: its name
    std::span<const std::string_view> types;  ///< ROS types that it may have, the usual one first
    std::string_view topic;                   ///< usual one, below the robot's name; absolute with a slash
    Qos qos;                                  ///< usual one
    bool ofCamera = false;                    ///< its topic lies below the name of its camera
    bool picture = false;
    bool single = false;     ///< a robot has at most one: it would be unclear which one to obey or believe
    bool shared = false;     ///< robots may share one topic for it
    bool steady = false;     ///< sent periodically; others only on a change or a request
    bool quick = false;      ///< ... several times a second
    bool alwaysOn = false;   ///< ... and no robot switches it off
    bool needed = false;     ///< must be received before a start, if the robot has it
    bool several = false;    ///< a guessed robot may have more than one; of cameras, one for each
    bool obstacles = false;  ///< shows what stands around the robot
    bool indexed = false;    ///< a review reads all of it when it opens the mission
    /// The lower, the better its stamps: of the computer whose clock matters most, written at once.
    int stampRank = 6;
    ThinRank thinRank = ThinRank::Kept;
    double usualRate = 1.0;        ///< [Hz]
    double usualMegabits = 0.005;  ///< [Mbit/s]
    ThinnedAs thinnedAs = ThinnedAs::Kept;
    std::string_view inLog = {};  ///< its name in sentences of the log; empty: the stream's own name
    GuessedBy guessedBy = GuessedBy::Type;
    std::span<const std::string_view> words = {};
};

inline constexpr const char* StreamTitles = "leitstand::LinkStatus";  ///< context of their translation

/// A row for each role, by rising number.
[[nodiscard]] std::span<const StreamFacts> streamTable();
[[nodiscard]] const StreamFacts& streamFacts(StreamRole role);

/// The ROS types that a stream of @p role may have; the first one is the usual one.
[[nodiscard]] std::span<const std::string_view> typesOf(StreamRole role);

}  // namespace leitstand
