#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/event/station_samples.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// How the link to a robot is.
enum class LinkState : std::uint8_t {
    NeverSeen,  ///< nothing came since the station began to listen
    Connected,
    Degraded,  ///< it speaks, but LinkStatus::reasons say what is wrong
    Lost,      ///< it spoke, and is silent now
};
/// "never seen", "connected", "degraded", "lost".
[[nodiscard]] std::string toString(LinkState state);

/// One thing that is wrong with a link.
struct LinkReason {
    enum class Kind : std::uint8_t {
        Silent,    ///< nothing at all was heard for so long [s]
        Stale,     ///< a steady stream stopped: age of its newest sample [s]
        Late,      ///< a steady stream comes, but so late [s]
        Loss,      ///< share of a stream's samples that never arrived, 0 to 1
        Slow,      ///< round trip of the pings [s]
        NoAnswer,  ///< it speaks, but has answered no ping for so long [s]
    };
    Kind kind = Kind::Silent;
    double value = 0.0;                         ///< as the kind says
    StreamRole role = StreamRole::Diagnostics;  ///< of Stale, Late, Loss
    std::string sensor = {};                    ///< of that stream; may be empty
    std::string topic = {};                     ///< of that stream
};
/// In words, for logs and tables (widgets translate by kind): "odometry 1.4 s old", "12 % of points lost",
/// "left pictures 2.0 s late", "round trip 380 ms", "no answer to pings for 3.1 s".
[[nodiscard]] std::string toString(const LinkReason& reason);
/// All of them: "odometry 1.4 s old, round trip 380 ms"; empty when there is none.
[[nodiscard]] std::string toString(const std::vector<LinkReason>& reasons);

/// How one stream of a robot comes in.
struct StreamStatus {
    StreamRole role = StreamRole::Points;
    std::string sensor;                                       ///< StreamDescription::sensor
    std::string topic;                                        ///< ROS name
    std::uint64_t samples = 0;                                ///< since the station began to listen
    std::uint64_t lost = 0;                                   ///< never arrived, by the writers' numbers
    double rate = 0.0;                                        ///< over the last seconds [Hz]
    double expectedRate = 0.0;                                ///< as learned from its writer [Hz]; 0: unknown
    double age = std::numeric_limits<double>::infinity();     ///< of the newest, by its arrival [s]
    double delay = std::numeric_limits<double>::quiet_NaN();  ///< from writing to arrival [s]; NaN: unknown
    double lossRatio = 0.0;                                   ///< over the last 10 s, 0 to 1, of a stale
                                                              ///< stream with what did not come; NaN: unknown
    double megabitsPerSecond = 0.0;                           ///< without headers and repeats; NaN: unknown
    bool steady = false;  ///< comes at a rate of its own; others come on change and are never stale
    bool stale = false;   ///< steady, and nothing came for longer than it should
    bool paused = false;  ///< switched off by the station: never stale
};

/// What the pings of the last seconds told; without the time that the robot held them.
struct RoundTripStatus {
    double last = 0.0;        ///< [s]
    double median = 0.0;      ///< [s]
    double age = 0.0;         ///< since the last answer [s]
    double unanswered = 0.0;  ///< share of the pings, 0 to 1
};

/// Where an estimate of a robot's clock comes from.
enum class ClockSource : std::uint8_t {
    Pings,   ///< both ways: good to half a round trip
    Stamps,  ///< one way: when samples were written; assumes that the quickest take no longer than 50 ms
};

/// How a robot's clock stands to the station's.
struct ClockStatus {
    std::chrono::nanoseconds ahead{};        ///< robot's clock minus station's
    std::chrono::nanoseconds uncertainty{};  ///< the truth is within ahead +- uncertainty
    ClockSource source = ClockSource::Pings;
    int steps = 0;                                             ///< how often it jumped
    std::chrono::nanoseconds lastStep{};                       ///< by how much, last time
    double stepAge = std::numeric_limits<double>::infinity();  ///< since then [s]
};

/// The link to one robot, as views show it.
struct LinkStatus {
    std::string robot;  ///< "kurt3d"
    LinkState state = LinkState::NeverSeen;
    double stateAge = 0.0;                                     ///< [s]
    std::vector<LinkReason> reasons;                           ///< why it is not Connected, worst first
    double silence = std::numeric_limits<double>::infinity();  ///< since anything of it was heard [s]
    std::optional<RoundTripStatus> roundTrip;                  ///< of robots that answer pings
    std::optional<ClockStatus> clock;
    int reconnects = 0;                 ///< how often it came back from Lost
    double megabitsPerSecond = 0.0;     ///< of all streams
    std::vector<StreamStatus> streams;  ///< in the order of the robot's description

    [[nodiscard]] const StreamStatus* stream(std::string_view topic) const;  ///< null: it has none such
};

/// What the log keeps of @p status, @p stamp on the station's clock; empty while the clock is unknown.
[[nodiscard]] std::optional<ClockOffsetSample> clockOffsetOf(const LinkStatus& status, Time stamp);

}  // namespace leitstand
