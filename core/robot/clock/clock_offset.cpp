#include "core/robot/clock/clock_offset.h"

#include <algorithm>
#include <cmath>

#include "core/base/time.h"

namespace leitstand {
namespace {

using std::chrono::nanoseconds;

/// Steps up to this are not reported: a slewed clock looks like them [ns].
constexpr std::int64_t QuietStep = 50'000'000;

ClockBounds widened(const ClockBounds& bounds, nanoseconds passed) {
    const auto drift = std::llround(PingClock::MaxDrift * std::abs(static_cast<double>(passed.count())));
    return {bounds.least - drift, bounds.most + drift};
}

std::optional<ClockBounds> both(const ClockBounds& a, const ClockBounds& b) {
    const ClockBounds common{std::max(a.least, b.least), std::min(a.most, b.most)};
    if (common.least > common.most) return std::nullopt;
    return common;
}

std::int64_t middle(const ClockBounds& bounds) {
    return bounds.least + (bounds.most - bounds.least) / 2;
}

}  // namespace

bool PingClock::add(const PingTimes& ping, SteadyTime now, std::optional<nanoseconds>* stepped) {
    ClockBounds reported{(ping.robotReplied - ping.received).count(),
                         (ping.robotReceived - ping.sent).count()};
    if (ping.received < ping.sent || ping.robotReplied < ping.robotReceived) return false;
    reported.least -= ReadingError;
    reported.most += ReadingError;
    if (reported.least > reported.most) return false;  // held for longer than it was away

    Doubt& place = m_doubts[m_count++ % Remembered];
    place = {reported, now, false};
    if (!m_bounds) {
        m_bounds = reported;
        m_at = now;
        return true;
    }
    const ClockBounds believed = widened(*m_bounds, now - m_at);
    if (const auto common = both(believed, reported)) {
        m_bounds = *common;
        m_at = now;
        return true;
    }
    place.open = true;
    const auto agreed = agreement(now);
    if (!agreed) return true;
    const std::int64_t step = middle(*agreed) - middle(believed);
    if (stepped != nullptr && std::abs(step) > QuietStep) *stepped = nanoseconds(step);
    m_bounds = *agreed;
    m_at = now;
    for (Doubt& doubt : m_doubts) doubt.open = false;
    return true;
}

std::optional<ClockBounds> PingClock::agreement(SteadyTime now) const {
    std::optional<ClockBounds> common;
    int agreeing = 0;
    for (std::size_t back = 1; back <= std::min<std::size_t>(m_count, Remembered); ++back) {
        const Doubt& doubt = m_doubts[(m_count - back) % Remembered];
        if (!doubt.open) continue;
        const ClockBounds bounds = widened(doubt.bounds, now - doubt.at);
        const auto next = common ? both(*common, bounds) : bounds;
        if (!next) continue;  // an outlier among outliers
        common = next;
        ++agreeing;
    }
    return agreeing >= Convinced ? common : std::nullopt;
}

std::optional<ClockEstimate> PingClock::estimate(SteadyTime now) const {
    if (!m_bounds) return std::nullopt;
    const ClockBounds bounds = widened(*m_bounds, now - m_at);
    return ClockEstimate{nanoseconds(middle(bounds)), nanoseconds(bounds.most - middle(bounds)),
                         ClockSource::Pings};
}

std::optional<std::int64_t> StampClock::envelope() const {
    std::optional<std::int64_t> most;
    for (const Second& second : m_seconds) {
        if (second.number >= 0 && (!most || second.most > *most)) most = second.most;
    }
    return most;
}

void StampClock::put(std::int64_t number, std::int64_t difference) {
    for (Second& second : m_seconds) {
        if (number - second.number >= Window || second.number > number) second.number = -1;
    }
    Second& place = m_seconds[static_cast<std::size_t>(number) % m_seconds.size()];
    if (place.number != number) place = {number, difference};
    place.most = std::max(place.most, difference);
}

void StampClock::add(Time written, Time received, SteadyTime now, std::optional<nanoseconds>* stepped) {
    const std::int64_t difference = (written - received).count();
    const auto second = std::chrono::floor<std::chrono::seconds>(now.time_since_epoch()).count();
    if (m_reported && difference > *m_reported + Step) {  // the future: a wrong stamp, or the clock stepped
        m_doubts = m_doubts > 0 && std::abs(difference - m_doubted) < Step ? m_doubts + 1 : 1;
        m_doubted = difference;
        if (m_doubts < Convinced) return;
        m_seconds.fill({});
    }
    m_doubts = 0;
    put(second, difference);
    const std::int64_t envelopeNow = *envelope();
    if (stepped != nullptr && m_reported && std::abs(envelopeNow - *m_reported) > Step)
        *stepped = nanoseconds(envelopeNow - *m_reported);
    m_reported = envelopeNow;
    m_at = now;
}

std::optional<ClockEstimate> StampClock::estimate(SteadyTime now) const {
    if (!m_reported) return std::nullopt;
    const auto drift =
        std::llround(PingClock::MaxDrift *
                     static_cast<double>(nanoseconds(now - m_at + std::chrono::seconds(Window)).count()));
    return ClockEstimate{nanoseconds(*m_reported + LeastDelay / 2), nanoseconds(LeastDelay / 2 + drift),
                         ClockSource::Stamps};
}

std::optional<ClockEstimate> ClockOffset::estimate(SteadyTime now) const {
    const auto pings = m_pings.estimate(now);
    if (pings && now - m_pings.newest() < PingsHold) return pings;
    const auto stamps = m_stamps.estimate(now);
    return stamps ? stamps : pings;
}

void ClockOffset::publish(const std::optional<nanoseconds>& stepped, SteadyTime now) {
    if (!stepped) return;
    ++m_steps;
    m_lastStep = *stepped;
    m_steppedAt = now;
}

bool ClockOffset::ping(const PingTimes& ping, SteadyTime now) {
    std::optional<nanoseconds> stepped;
    const bool sane = m_pings.add(ping, now, &stepped);
    publish(stepped, now);
    return sane;
}

void ClockOffset::stamp(Time written, Time received, SteadyTime now) {
    const auto before = estimate(now);
    std::optional<nanoseconds> stepped;
    m_stamps.add(written, received, now, &stepped);
    if (before && before->source == ClockSource::Stamps)
        publish(stepped, now);  // otherwise the pings report it
}

std::optional<ClockStatus> ClockOffset::status(SteadyTime now) const {
    const auto known = estimate(now);
    if (!known) return std::nullopt;
    ClockStatus status;
    status.ahead = known->ahead;
    status.uncertainty = known->uncertainty;
    status.source = known->source;
    status.steps = m_steps;
    status.lastStep = m_lastStep;
    if (m_steps > 0) status.stepAge = toSeconds(now - m_steppedAt);
    return status;
}

}  // namespace leitstand
