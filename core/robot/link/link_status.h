#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct ClockOffsetSample;

/// State of the link to a robot.
enum class LinkState : std::uint8_t {
    NeverSeen,  ///< nothing was received since the station began to listen
    Connected,
    Degraded,  ///< samples are received, but LinkStatus::reasons name faults
    Lost,      ///< samples were received before, but none are now
};
/// "never seen", "connected", "degraded", "lost".
[[nodiscard]] std::string toString(LinkState state);

/// One fault of a link.
struct LinkReason {
    enum class Kind : std::uint8_t {
        Silent,    ///< nothing at all was received for this long [s]
        Stale,     ///< a steady stream stopped: age of its newest sample [s]
        Late,      ///< a steady stream arrives with this delay [s]
        Loss,      ///< share of a stream's samples that never arrived, 0 to 1
        Slow,      ///< round trip of the pings [s]
        NoAnswer,  ///< the robot is heard, but has answered no ping for this long [s]
    };
    Kind kind = Kind::Silent;
    double value = 0.0;       ///< its meaning depends on the kind
    StreamRole role{};        ///< for Stale, Late, Loss
    std::string sensor = {};  ///< sensor of that stream; may be empty
    std::string topic = {};   ///< topic of that stream
};
/// Text for logs and tables (widgets translate by kind): "odometry 1.4 s old", "12 % of points lost", "round
/// trip 380 ms", "no answer to pings for 3.1 s".
[[nodiscard]] std::string toString(const LinkReason& reason);
/// All @p reasons in one text: "odometry 1.4 s old, round trip 380 ms"; empty without reasons.
[[nodiscard]] std::string toString(const std::vector<LinkReason>& reasons);

/// State of one stream of a robot.
struct StreamStatus {
    StreamRole role{};
    std::string sensor;         ///< StreamDescription::sensor
    std::string topic;          ///< ROS name
    std::uint64_t samples = 0;  ///< since the station began to listen
    std::uint64_t lost = 0;     ///< number of samples that never arrived, from the writers' numbers
    double rate = 0.0;          ///< over the last seconds [Hz]
    double expectedRate = 0.0;  ///< learned from the times of its samples [Hz]; 0: unknown
    double age = std::numeric_limits<double>::infinity();     ///< since the newest sample arrived [s]
    double delay = std::numeric_limits<double>::quiet_NaN();  ///< from writing to arrival [s]; NaN: unknown
    /// Lost share over the last 10 s, 0 to 1; missing samples of a stale stream are included; NaN: unknown.
    double lossRatio = 0.0;
    double megabitsPerSecond = 0.0;  ///< without headers and repeated packets; NaN: unknown
    /// Whether samples come periodically; otherwise they come on change and are never stale.
    bool steady = false;
    bool stale = false;   ///< whether it is steady and no sample came for longer than expected
    bool paused = false;  ///< whether the station switched it off; then it is never stale
};

/// Round trips of the pings in the last 10 s, without the time that the robot needed to answer.
struct RoundTripStatus {
    double last = 0.0;        ///< newest round trip [s]
    double median = 0.0;      ///< [s]
    double age = 0.0;         ///< since the last answer [s]
    double unanswered = 0.0;  ///< share of the pings without an answer, 0 to 1
};

/// How a robot's clock is estimated.
enum class ClockSource : std::uint8_t {
    Pings,   ///< from both directions: the error is at most half a round trip
    Stamps,  ///< from one direction, by the stamps of samples; assumes that the quickest take at most 50 ms
};

/// A robot's clock relative to the station's.
struct ClockStatus {
    std::chrono::nanoseconds ahead{};        ///< robot's clock minus station's
    std::chrono::nanoseconds uncertainty{};  ///< the true difference is within ahead +- uncertainty
    ClockSource source = ClockSource::Pings;
    int steps = 0;                                             ///< number of steps of the clock so far
    std::chrono::nanoseconds lastStep{};                       ///< size of the last step
    double stepAge = std::numeric_limits<double>::infinity();  ///< since the last step [s]
};

/// The link to one robot, as views show it.
struct LinkStatus {
    std::string robot;  ///< "kurt3d"
    LinkState state = LinkState::NeverSeen;
    double stateAge = 0.0;            ///< time in this state [s]
    std::vector<LinkReason> reasons;  ///< why it is not Connected: faults of streams, then of pings
    /// Since anything was received from the robot [s]; infinite: never.
    double silence = std::numeric_limits<double>::infinity();
    std::optional<RoundTripStatus> roundTrip;  ///< for robots that answer pings
    std::optional<ClockStatus> clock;
    int reconnects = 0;                 ///< how often it came back from Lost
    double megabitsPerSecond = 0.0;     ///< sum of all streams
    std::vector<StreamStatus> streams;  ///< in the order of the robot's description

    /// Null: there is no such stream.
    [[nodiscard]] const StreamStatus* stream(std::string_view topic) const;
};

/// Returns the sample about @p status for the log, with @p stamp (station's clock). Empty while the clock is
/// unknown.
[[nodiscard]] std::optional<ClockOffsetSample> clockOffsetOf(const LinkStatus& status, Time stamp);

}  // namespace leitstand
