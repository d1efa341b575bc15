#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/event/stream_role.h"
#include "core/robot/streams/qos.h"

namespace leitstand {

/// What a thin link gives up first: the last of these (thinWishes()).
enum class ThinRank : std::uint8_t { Kept, Telemetry, Scans, Pictures };

/// What of a stream a thinned mission keeps (ThinSettings of thinMission()).
enum class ThinnedAs : std::uint8_t { Kept, Cloud, Ranges, Picture, Motion, Other };

/// By what the role of a topic is told that no robot's file names.
enum class ToldBy : std::uint8_t {
    /// The first of StreamFacts::types; another one, if there are words, with one of them in its name.
    Type,
    Name,   ///< its name ends with StreamFacts::topic, and its type is one of them
    Words,  ///< a word of its name is one of StreamFacts::words, and its type is one of them
};

/// All that is known of the streams of one role.
struct StreamFacts {
    StreamRole role = StreamRole::Points;
    const char* title = nullptr;              ///< for operators, translated in StreamTitles; null: its name
    std::span<const std::string_view> types;  ///< ROS types that it may have, the usual one first
    std::string_view topic;                   ///< usual one, below the robot's name; with a slash as it is
    Qos qos;                                  ///< usual one
    bool ofCamera = false;                    ///< its topic lies below the name of its camera
    bool picture = false;
    bool single = false;    ///< a robot has at most one: which one would be obeyed, or believed?
    bool shared = false;    ///< robots may say it on one topic together
    bool steady = false;    ///< comes again and again; others only when something changes, or is asked
    bool quick = false;     ///< ... several times a second
    bool alwaysOn = false;  ///< ... and no robot switches it off
    bool needed = false;    ///< before a start, a robot that has it says it
    /// The lower, the more its stamps are of the computer whose clock matters most, written at once.
    int stampRank = 6;
    ThinRank thinRank = ThinRank::Kept;
    double usualRate = 1.0;        ///< [Hz]
    double usualMegabits = 0.005;  ///< a second
    ThinnedAs thinnedAs = ThinnedAs::Kept;
    std::string_view inLog = {};  ///< what sentences of the log call it; empty: by its name
    ToldBy toldBy = ToldBy::Type;
    std::span<const std::string_view> words = {};
    bool tellsRobot = false;  ///< whose topic is the usual one directly below a name, that is a robot's
};

inline constexpr const char* StreamTitles = "leitstand::LinkStatus";  ///< context of their translation

/// A row for each role, in the order of their declaration.
[[nodiscard]] std::span<const StreamFacts> streamTable();
[[nodiscard]] const StreamFacts& streamFacts(StreamRole role);

/// The ROS types that a stream of @p role may have; the first one is the usual one.
[[nodiscard]] std::span<const std::string_view> typesOf(StreamRole role);

}  // namespace leitstand
