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

/// Limits beyond which a link is degraded or lost. A value is reported when it exceeds its limit, and cleared
/// when it falls below its second limit `...Over`. The link is connected again after `recovery` seconds
/// without a reason.
struct LinkRules {
    /// The link is lost after this time without a sample [s]; longer if even the quickest stream is slow ...
    double lostAfter = 2.0;
    double lostAtMost = 10.0;  ///< ... but at most this [s]
    int backAfter = 3;         ///< number of samples after which a lost link is connected again
    /// A steady stream is stale after this silence [s], but at least three of its intervals.
    double staleAfter = 1.0;
    double slowest = 10.0;         ///< streams with longer intervals are not steady [s]
    double forgottenAfter = 60.0;  ///< a stream that is stale for longer no longer affects the link [s]
    /// Lost share of a stream's samples; the limit is higher if there are few.
    double loss = 0.10, lossOver = 0.06;
    int lossBasis = 20;                 ///< with fewer samples than this, no loss is computed
    double late = 1.0, lateOver = 0.5;  ///< delay of steady streams, from writing to arrival [s]
    /// A delay is reported only after this time [s], since a clock that steps first looks like a delay.
    double lateFor = 2.0;
    double roundTrip = 0.300, roundTripOver = 0.200;  ///< median round trip of pings [s]
    double noAnswer = 3.0;  ///< time without an answer, for a robot that has answered before [s]
    double recovery = 2.0;  ///< time without a reason until the link is connected again [s]
};

/// Judges the link to one robot by the samples that arrive. Pure: no clock of its own, no thread; constant
/// memory, and no allocation except in status(). Observes all streams in the robot's description except
/// commands.
class LinkMonitor {
public:
    explicit LinkMonitor(const RobotDescription& robot, const LinkRules& rules = {});

    /// Takes a sample on @p topic (ROS name). Ignores topics that the description does not list.
    void sample(std::string_view topic, const StreamArrival& arrival, SteadyTime now);
    /// Takes ping @p number of this station. @p stamp: when it is sent, on the station's clock.
    void ping(std::uint64_t number, Time stamp, SteadyTime now);
    /// Takes an answer to a ping of this station. @p received: arrival on the station's clock. Pass its
    /// sample to sample(), too. Returns false when the answer belongs to no remembered ping, or its times
    /// contradict each other.
    bool pong(const PongSample& pong, Time received, SteadyTime now);
    /// Call when the station switched a stream off (@p paused) or on again: while it is off, silence is no
    /// fault. Unknown topics are ignored.
    void setPaused(std::string_view topic, bool paused, SteadyTime now);

    /// Returns the state at @p now; call it a few times a second.
    [[nodiscard]] LinkStatus status(SteadyTime now);

private:
    struct Stream {
        StreamRole role{};
        std::string sensor = {}, topic = {};
        bool steadyRole = true;  ///< whether samples come periodically; in other streams they come on change
        /// Other robots publish on the topic, too: its samples do not show that this robot is alive.
        bool shared = false;
        int stampRank = 0;  ///< the clock is estimated from the streams with the lowest rank
        StreamMonitor monitor = {};
        bool paused = false, lossy = false, late = false;
        bool knownClock = false;       ///< whether its stamps come from the clock that the pings measure
        SteadyTime onTime = {};        ///< when its samples were last on time
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
    std::vector<std::uint32_t> m_byTopic;  ///< indices in m_streams, sorted by topic
    ClockOffset m_clock;
    RoundTrips m_roundTrips;
    int m_stampRank;  ///< lowest rank of the streams received so far
    LinkState m_state = LinkState::NeverSeen;
    SteadyTime m_since;      ///< when the present state began
    SteadyTime m_spoke;      ///< since when the link has not been lost
    SteadyTime m_received;   ///< when the last sample or answer arrived
    SteadyTime m_faultless;  ///< when there was last a reason
    bool m_began = false;    ///< whether m_since is set
    bool m_slow = false;     ///< whether the round trip is over its limit
    int m_signs = 0;         ///< number of samples since it was lost
    int m_reconnects = 0;
    std::vector<LinkReason> m_reasons;  ///< newest reasons that were not empty
};

}  // namespace leitstand
