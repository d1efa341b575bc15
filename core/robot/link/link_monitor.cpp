#include "core/robot/link/link_monitor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/time.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

constexpr double PongInterval = 0.5;  ///< of robots that answer pings [s]
/// Deviations by which a loss must exceed the limit: bad luck with few samples is no bad link.
constexpr double ChanceOfLoss = 1.5;
constexpr int NoRank = 100;
/// Robots may have several clocks: delays are given only of streams that were once this quick [s].
constexpr double OnTime = 0.25;
constexpr std::chrono::milliseconds SureEnough{200};  ///< largest uncertainty of a clock for delays

/// Whether robots share the topic and it is not this robot's own: "/tf", "/diagnostics".
bool isShared(const StreamDescription& stream, const std::string& robot) {
    return streamFacts(stream.role).shared && !stream.topic.starts_with("/" + robot + "/");
}

/// Whether a value is over @p limit or, once it was, not yet down to @p over.
bool isOver(double value, double limit, double over, bool before) {
    return value > (before ? over : limit);
}

}  // namespace

LinkMonitor::LinkMonitor(const RobotDescription& robot, const LinkRules& rules)
    : m_rules(rules), m_robot(robot.name), m_stampRank(NoRank) {
    for (const StreamDescription& stream : robot.streams) {
        if (isCommand(stream.role)) continue;
        Stream& its = m_streams.emplace_back();
        its.role = stream.role;
        its.sensor = stream.sensor;
        its.topic = stream.topic;
        its.steadyRole = streamFacts(stream.role).steady;
        its.shared = isShared(stream, robot.name);
        its.stampRank = its.shared ? NoRank : streamFacts(stream.role).stampRank;
    }
    m_byTopic.resize(m_streams.size());
    std::iota(m_byTopic.begin(), m_byTopic.end(), 0U);
    std::sort(m_byTopic.begin(), m_byTopic.end(),
              [&](auto a, auto b) { return m_streams[a].topic < m_streams[b].topic; });
}

void LinkMonitor::sample(std::string_view topic, const StreamArrival& arrival, SteadyTime now) {
    auto place = std::lower_bound(m_byTopic.begin(), m_byTopic.end(), topic,
                                  [&](auto one, auto name) { return m_streams[one].topic < name; });
    for (; place != m_byTopic.end() && m_streams[*place].topic == topic; ++place) {
        Stream& stream = m_streams[*place];
        stream.monitor.add(arrival, now);
        if (stream.shared) continue;
        signOfLife(now);
        if (arrival.written == Time{} || stream.stampRank > m_stampRank) continue;
        m_stampRank = stream.stampRank;
        m_clock.stamp(arrival.written, arrival.received, now);
    }
}

void LinkMonitor::ping(std::uint64_t number, Time stamp, SteadyTime now) {
    m_roundTrips.sent(number, stamp, now);
}

bool LinkMonitor::pong(const PongSample& pong, Time received, SteadyTime now) {
    if (pong.replied < pong.received) return false;
    if (!m_roundTrips.answered(pong.number, pong.sent, pong.replied - pong.received, now)) return false;
    signOfLife(now);
    return m_clock.ping({pong.sent, pong.received, pong.replied, received}, now);
}

void LinkMonitor::setPaused(std::string_view topic, bool paused, SteadyTime now) {
    for (Stream& stream : m_streams) {
        if (stream.topic != topic || stream.paused == paused) continue;
        stream.paused = paused;
        stream.expectedFrom = now;
    }
}

bool LinkMonitor::isSilent(SteadyTime now) const {
    const double silence = toSeconds(now - m_received);
    if (silence <= m_rules.lostAfter) return false;
    double quickest = m_roundTrips.status(now) ? PongInterval : m_rules.lostAtMost;
    for (const Stream& stream : m_streams) {
        if (!stream.steadyRole || stream.shared || stream.paused) continue;
        quickest = std::min(quickest, stream.monitor.interval().value_or(quickest));
    }
    return silence > std::clamp(4.0 * quickest, m_rules.lostAfter, m_rules.lostAtMost);
}

void LinkMonitor::enter(LinkState state, SteadyTime now) {
    if (state == m_state && m_began) return;
    if (m_state == LinkState::Lost) ++m_reconnects;
    if (m_state == LinkState::Lost || m_state == LinkState::NeverSeen) m_spoke = now;
    m_state = state;
    m_since = now;
    m_began = true;
    m_signs = 0;
    if (state != LinkState::Degraded) m_reasons.clear();
}

void LinkMonitor::signOfLife(SteadyTime now) {
    const bool speaks = m_state == LinkState::Connected || m_state == LinkState::Degraded;
    if (speaks && isSilent(now)) enter(LinkState::Lost, now);  // also without a call of status() meanwhile
    m_received = std::max(m_received, now);                    // two threads of the node call this
    ++m_signs;
    if (m_state == LinkState::NeverSeen || (m_state == LinkState::Lost && m_signs >= m_rules.backAfter))
        enter(LinkState::Connected, now);  // until it is judged
}

StreamStatus LinkMonitor::statusOf(const Stream& stream, SteadyTime now) const {
    const StreamFigures figures = stream.monitor.figures(now);
    const auto interval = stream.monitor.interval();
    StreamStatus status;
    status.role = stream.role;
    status.sensor = stream.sensor;
    status.topic = stream.topic;
    status.samples = stream.monitor.samples();
    status.lost = stream.monitor.lost();
    status.rate = figures.rate;
    status.age = figures.age;
    status.lossRatio = figures.lossRatio;
    status.megabitsPerSecond = figures.megabitsPerSecond;
    status.paused = stream.paused;
    status.steady = stream.steadyRole && interval && *interval <= m_rules.slowest;
    if (status.steady) status.expectedRate = 1.0 / *interval;
    const double patience = std::max(m_rules.staleAfter, 3.0 * interval.value_or(0.0));
    const double expectedFor = toSeconds(now - std::max(stream.expectedFrom, stream.monitor.newest()));
    status.stale = status.steady && !status.paused && expectedFor > patience;
    if (status.stale) {
        // Expected samples that do not come count as lost: no gap in the numbers shows them yet.
        const double window = toSeconds(StreamMonitor::Slots * StreamMonitor::Slot);
        const double silent = status.expectedRate * std::min(window, status.age);
        const auto all = static_cast<double>(figures.lossBasis);
        status.lossRatio = (figures.lossRatio * all + silent) / (all + silent);
    }
    return status;
}

void LinkMonitor::publishDelay(Stream& stream, StreamStatus& status, const LinkStatus& link,
                               SteadyTime now) const {
    const auto transit = stream.monitor.figures(now).transit;
    if (!transit || !link.clock || link.clock->source != ClockSource::Pings ||
        link.clock->uncertainty > SureEnough)
        return;
    const double delay = toSeconds(*transit + link.clock->ahead);
    const double least = -toSeconds(link.clock->uncertainty) - 0.05;
    if (delay < least) stream.knownClock = false;  // written after it arrived
    if (delay >= least && delay < OnTime) stream.knownClock = true;
    if (stream.knownClock) status.delay = std::max(0.0, delay);
}

void LinkMonitor::findFaults(Stream& stream, const StreamStatus& status, SteadyTime now,
                             std::vector<LinkReason>& reasons) {
    const auto add = [&](LinkReason::Kind kind, double value) {
        reasons.push_back({kind, value, stream.role, stream.sensor, stream.topic});
    };
    const SteadyTime expected = std::max({stream.expectedFrom, stream.monitor.newest(), m_spoke});
    const bool forgotten = toSeconds(now - expected) > m_rules.forgottenAfter;
    if (status.stale && !forgotten) add(LinkReason::Kind::Stale, status.age);
    const StreamFigures figures = stream.monitor.figures(now);
    const auto basis = figures.lossBasis;
    const double chance = ChanceOfLoss * std::sqrt(m_rules.loss * (1.0 - m_rules.loss) /
                                                   static_cast<double>(std::max<std::uint64_t>(basis, 1)));
    stream.lossy = !stream.paused && basis >= static_cast<std::uint64_t>(m_rules.lossBasis) &&
                   isOver(figures.lossRatio, m_rules.loss + chance, m_rules.lossOver, stream.lossy);
    if (stream.lossy) add(LinkReason::Kind::Loss, figures.lossRatio);
    const bool late = status.steady && !status.stale && !stream.paused && !std::isnan(status.delay) &&
                      isOver(status.delay, m_rules.late, m_rules.lateOver, stream.late);
    if (!late) stream.onTime = now;
    stream.late = late && (stream.late || toSeconds(now - stream.onTime) >= m_rules.lateFor);
    if (stream.late) add(LinkReason::Kind::Late, status.delay);
}

void LinkMonitor::findPingFaults(const LinkStatus& link, SteadyTime now, std::vector<LinkReason>& reasons) {
    const double waiting = m_roundTrips.waiting(now);
    if (waiting > m_rules.noAnswer) reasons.push_back({.kind = LinkReason::Kind::NoAnswer, .value = waiting});
    m_slow = link.roundTrip && waiting <= m_rules.noAnswer &&
             isOver(link.roundTrip->median, m_rules.roundTrip, m_rules.roundTripOver, m_slow);
    if (m_slow) reasons.push_back({.kind = LinkReason::Kind::Slow, .value = link.roundTrip->median});
}

void LinkMonitor::judge(std::vector<LinkReason> reasons, SteadyTime now) {
    if (m_state == LinkState::NeverSeen) return;
    if (m_state != LinkState::Lost && isSilent(now)) enter(LinkState::Lost, now);
    if (m_state == LinkState::Lost) {
        m_reasons = {{.kind = LinkReason::Kind::Silent, .value = toSeconds(now - m_received)}};
    } else if (!reasons.empty()) {
        enter(LinkState::Degraded, now);
        m_reasons = std::move(reasons);
        m_faultless = now;
    } else if (m_state == LinkState::Degraded && toSeconds(now - m_faultless) >= m_rules.recovery) {
        enter(LinkState::Connected, now);
    }
}

LinkStatus LinkMonitor::status(SteadyTime now) {
    if (!m_began) enter(LinkState::NeverSeen, now);
    LinkStatus link;
    link.robot = m_robot;
    link.roundTrip = m_roundTrips.status(now);
    link.clock = m_clock.status(now);
    std::vector<LinkReason> reasons;
    link.streams.reserve(m_streams.size());
    for (Stream& stream : m_streams) {
        link.streams.push_back(statusOf(stream, now));
        publishDelay(stream, link.streams.back(), link, now);
        link.megabitsPerSecond += link.streams.back().megabitsPerSecond;
        if (!stream.shared) findFaults(stream, link.streams.back(), now, reasons);
    }
    findPingFaults(link, now, reasons);
    judge(std::move(reasons), now);
    link.state = m_state;
    link.stateAge = std::max(0.0, toSeconds(now - m_since));
    link.reasons = m_reasons;
    if (m_state != LinkState::NeverSeen) link.silence = std::max(0.0, toSeconds(now - m_received));
    link.reconnects = m_reconnects;
    return link;
}

}  // namespace leitstand
