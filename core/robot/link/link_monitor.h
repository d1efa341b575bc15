#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/robot/clock/clock_offset.h"
#include "core/robot/link/link_status.h"
#include "core/robot/link/round_trips.h"
#include "core/robot/link/stream_monitor.h"

namespace leitstand {

struct PongSample;

/// Rules for when a link counts as degraded or lost. A value is reported when it exceeds its limit, and
/// cleared when it falls below `...Over`. The link is connected again after `recovery` seconds without a
/// reason.
struct LinkRules {
    double lostAfter = 2.0;  ///< time without a sign of life [s]; more where even the quickest stream is slow
    double lostAtMost = 10.0;      ///< ... but at most this [s]
    int backAfter = 3;             ///< number of samples after which a lost link is back
    double staleAfter = 1.0;       ///< silence of a steady stream [s], but at least three of its intervals
    double slowest = 10.0;         ///< streams with longer intervals are not steady [s]
    double forgottenAfter = 60.0;  ///< a stream stale for longer no longer affects the link [s]
    double loss = 0.10, lossOver = 0.06;  ///< lost share of a stream's samples; higher where they are few
    int lossBasis = 20;                   ///< fewer samples give no loss
    double late = 1.0, lateOver = 0.5;    ///< of steady streams, from writing to arrival [s]
    double lateFor = 2.0;  ///< late only after this time [s]: a clock that steps looks late at first
    double roundTrip = 0.300, roundTripOver = 0.200;  ///< median round trip of pings [s]
    double noAnswer = 3.0;  ///< time without an answer, from a robot that answered before [s]
    double recovery = 2.0;  ///< [s]
};

/// Judges the link to one robot by what arrives. Pure: no clock of its own, no thread; constant memory, no
/// allocation except in status(). Watches the streams of the robot's description except commands.
class LinkMonitor {
public:
    explicit LinkMonitor(const RobotDescription& robot, const LinkRules& rules = {});

    /// Takes a sample on @p topic (ROS name); topics that the description does not list are ignored.
    void sample(std::string_view topic, const StreamArrival& arrival, SteadyTime now);
    /// Takes ping @p number of this station, which is being sent with @p stamp on the station's clock.
    void ping(std::uint64_t number, Time stamp, SteadyTime now);
    /// Takes an answer to a ping of this station, @p received on its clock; pass its sample to sample() too.
    /// False when the answer belongs to no remembered ping or its times contradict each other.
    bool pong(const PongSample& pong, Time received, SteadyTime now);
    /// Call when the station switched a stream off (@p paused) or on again: silence is then no fault. Unknown
    /// topics are ignored.
    void setPaused(std::string_view topic, bool paused, SteadyTime now);

    /// Returns the state at @p now; call it a few times a second.
    [[nodiscard]] LinkStatus status(SteadyTime now);

private:
    struct Stream {
        StreamRole role{};
        std::string sensor = {}, topic = {};
        bool steadyRole = true;  ///< comes periodically; others come on change
        bool shared = false;  ///< other robots publish there too: its samples are no sign of life of this one
        int stampRank = 0;    ///< the clock is estimated from the streams of the lowest rank
        StreamMonitor monitor = {};
        bool paused = false, lossy = false, late = false;
        bool knownClock = false;       ///< its stamps are by the clock that the pings measure
        SteadyTime onTime = {};        ///< when it was last on time
        SteadyTime expectedFrom = {};  ///< when it was switched on again
    };
    void signOfLife(SteadyTime now);
    void enter(LinkState state, SteadyTime now);
    void judge(std::vector<LinkReason> reasons, SteadyTime now);
    [[nodiscard]] bool isSilent(SteadyTime now) const;
    [[nodiscard]] StreamStatus statusOf(const Stream& stream, SteadyTime now) const;
    void publishDelay(Stream& stream, StreamStatus& status, const LinkStatus& link, SteadyTime now) const;
    void findFaults(Stream& stream, const StreamStatus& status, SteadyTime now,
                    std::vector<LinkReason>& reasons);
    void findPingFaults(const LinkStatus& link, SteadyTime now, std::vector<LinkReason>& reasons);

    LinkRules m_rules;
    std::string m_robot;
    std::vector<Stream> m_streams;
    std::vector<std::uint32_t> m_byTopic;  ///< places in m_streams, sorted by topic
    ClockOffset m_clock;
    RoundTrips m_roundTrips;
    int m_stampRank;  ///< lowest rank that was received
    LinkState m_state = LinkState::NeverSeen;
    SteadyTime m_since;      ///< since when in this state
    SteadyTime m_spoke;      ///< since when not lost
    SteadyTime m_received;   ///< last sign of life
    SteadyTime m_faultless;  ///< when there was last a reason
    bool m_began = false;    ///< whether m_since is set
    bool m_slow = false;     ///< whether the round trip is over its limit
    int m_signs = 0;         ///< signs of life since it was lost
    int m_reconnects = 0;
    std::vector<LinkReason> m_reasons;  ///< the newest non-empty ones
};

}  // namespace leitstand
