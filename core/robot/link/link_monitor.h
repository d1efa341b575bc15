#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/event/status_samples.h"
#include "core/robot/clock/clock_offset.h"
#include "core/robot/link/link_status.h"
#include "core/robot/link/round_trips.h"
#include "core/robot/link/stream_monitor.h"

namespace leitstand {

/// When a link counts as degraded or lost. What is over a limit is told at once; what fell below `...Over` is
/// forgiven, and the link is connected again after `recovery` seconds without a reason.
struct LinkRules {
    double lostAfter = 2.0;    ///< silence of everything [s]; longer for robots whose quickest stream is slow
    double lostAtMost = 10.0;  ///< ... but no longer than that [s]
    int backAfter = 3;         ///< samples that must come before a lost link is no longer lost
    double staleAfter = 1.0;   ///< silence of a steady stream [s], but at least three of its intervals
    double slowest = 10.0;     ///< streams with longer intervals are not steady [s]
    double forgottenAfter = 60.0;         ///< stale for so long: no matter of the link any more [s]
    double loss = 0.10, lossOver = 0.06;  ///< of a stream's samples; more where they are few
    int lossBasis = 20;                   ///< fewer samples tell no loss
    double late = 1.0, lateOver = 0.5;    ///< of steady streams, from writing to arrival [s]
    double lateFor = 2.0;                 ///< ... for so long: a clock that steps looks late at first [s]
    double roundTrip = 0.300, roundTripOver = 0.200;  ///< median [s]
    double noAnswer = 3.0;                            ///< of a robot that answered pings before [s]
    double recovery = 2.0;                            ///< [s]
};

/// How the link to one robot is, from what arrives. Pure: no clock of its own, no thread; constant memory,
/// no allocation but in status(). Streams are those that its description lists, commands left out.
class LinkMonitor {
public:
    explicit LinkMonitor(const RobotDescription& robot, const LinkRules& rules = {});

    /// A sample on @p topic (ROS name); topics that the description does not list are ignored.
    void sample(std::string_view topic, const StreamArrival& arrival, SteadyTime now);
    /// Ping @p number of this station is being sent, @p stamp on the station's clock.
    void ping(std::uint64_t number, Time stamp, SteadyTime now);
    /// An answer to this station, @p received on its clock; the sample that it came in goes to sample(), too.
    /// False, and nothing was learned, when it answers no ping that is remembered, or contradicts itself.
    bool pong(const PongSample& pong, Time received, SteadyTime now);
    /// The station switched a stream off (or on again): silence is no fault. Unknown topics are ignored.
    void setPaused(std::string_view topic, bool paused, SteadyTime now);

    /// The state is as of @p now; call it a few times a second.
    [[nodiscard]] LinkStatus status(SteadyTime now);

private:
    struct Stream {
        StreamRole role = StreamRole::Points;
        std::string sensor = {}, topic = {};
        bool steadyRole = true;  ///< comes at a rate; others on change
        bool shared = false;     ///< other robots speak on it too: no sign of this one's life
        int stampRank = 0;       ///< streams of lowest rank tell the clock
        StreamMonitor monitor = {};
        bool paused = false, lossy = false, late = false;
        bool knownClock = false;       ///< its times are of the clock that the pings tell
        SteadyTime onTime = {};        ///< when it was last
        SteadyTime expectedFrom = {};  ///< when it was switched on again
    };
    void heard(SteadyTime now);
    void enter(LinkState state, SteadyTime now);
    void judge(std::vector<LinkReason> reasons, SteadyTime now);
    [[nodiscard]] bool isSilent(SteadyTime now) const;
    [[nodiscard]] StreamStatus statusOf(const Stream& stream, SteadyTime now) const;
    void tellDelay(Stream& stream, StreamStatus& status, const LinkStatus& link, SteadyTime now) const;
    void findFaults(Stream& stream, const StreamStatus& status, SteadyTime now,
                    std::vector<LinkReason>& reasons);
    void findPingFaults(const LinkStatus& link, SteadyTime now, std::vector<LinkReason>& reasons);

    LinkRules m_rules;
    std::string m_robot;
    std::vector<Stream> m_streams;
    std::vector<std::uint32_t> m_byTopic;  ///< places in m_streams, sorted by topic
    ClockOffset m_clock;
    RoundTrips m_roundTrips;
    int m_stampRank;  ///< lowest that came
    LinkState m_state = LinkState::NeverSeen;
    SteadyTime m_since;      ///< since when in this state
    SteadyTime m_spoke;      ///< since when not lost
    SteadyTime m_heard;      ///< last sign of life
    SteadyTime m_faultless;  ///< last reason
    bool m_began = false;    ///< m_since has a meaning
    bool m_slow = false;     ///< round trip
    int m_signs = 0;         ///< of life since it was lost
    int m_reconnects = 0;
    std::vector<LinkReason> m_reasons;  ///< newest that there were
};

}  // namespace leitstand
