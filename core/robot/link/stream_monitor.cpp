#include "core/robot/link/stream_monitor.h"

#include <algorithm>

#include "core/base/time.h"

namespace leitstand {
namespace {

constexpr std::uint64_t LargestGap = 1'000'000;  ///< a larger gap is no loss, but a writer with other numbers
constexpr double LearningShare = 0.1;            ///< weight of a new interval in the mean
constexpr double MuchLonger = 4.0;               ///< times the usual interval: a pause, or slower from now on

std::int64_t slotOf(SteadyTime now) {
    return now.time_since_epoch() / std::chrono::nanoseconds(StreamMonitor::Slot);
}

}  // namespace

StreamMonitor::Writer& StreamMonitor::writerOf(const StreamArrival& arrival) {
    Writer* oldest = &m_writers[0];
    for (Writer& writer : m_writers) {
        if (writer.known && writer.id == arrival.writer) return writer;
        if (!writer.known || (oldest->known && writer.arrived < oldest->arrived)) oldest = &writer;
    }
    *oldest = {};
    oldest->id = arrival.writer;
    return *oldest;
}

void StreamMonitor::learn(const Writer& before, const StreamArrival& arrival, SteadyTime now) {
    const std::uint64_t steps =
        arrival.sequence == 0 || before.sequence == 0 ? 1 : arrival.sequence - before.sequence;
    const bool reported = before.written != Time{} && arrival.written > before.written;
    const double passed =
        reported ? toSeconds(arrival.written - before.written) : toSeconds(now - before.arrived);
    const double interval = passed / static_cast<double>(steps);
    if (m_intervals == 0) {
        m_interval = interval;
    } else if (interval > MuchLonger * m_interval && interval > 0.5) {
        if (++m_long < Convinced) return;
        m_interval = interval;
    } else {
        m_interval += LearningShare * (interval - m_interval);
    }
    m_long = 0;
    m_intervals = std::min(m_intervals + 1, Learned);
}

void StreamMonitor::add(const StreamArrival& arrival, SteadyTime now) {
    Writer& writer = writerOf(arrival);
    const bool follows = writer.known && (arrival.sequence == 0 || arrival.sequence > writer.sequence);
    std::uint64_t lost = 0;
    if (follows && arrival.sequence != 0 && writer.sequence != 0) {
        const std::uint64_t missing = arrival.sequence - writer.sequence - 1;
        if (missing <= LargestGap) {
            lost = missing;
            learn(writer, arrival, now);
        }
    } else if (follows) {
        learn(writer, arrival, now);
    }
    if (follows || !writer.known) {  // others are repeats of earlier samples
        writer.sequence = arrival.sequence;
        writer.written = arrival.written;
    }
    writer.arrived = now;
    writer.known = true;

    m_transit.reset();
    if (arrival.written != Time{}) m_transit = arrival.received - arrival.written;
    Count& count = m_counts[static_cast<std::size_t>(slotOf(now) % Slots)];
    if (count.slot != slotOf(now)) {
        count = {};
        count.slot = slotOf(now);
        count.first = now;
    }
    ++count.samples;
    count.lost += lost;
    count.bytes += arrival.bytes;
    if (m_transit) count.transit = std::min(count.transit.value_or(*m_transit), *m_transit);
    ++m_samples;
    m_lost += lost;
    m_newest = now;
}

StreamFigures StreamMonitor::figures(SteadyTime now) const {
    StreamFigures figures;
    if (m_samples == 0) return figures;
    figures.age = std::max(0.0, toSeconds(now - m_newest));
    figures.transit = m_transit;
    std::uint64_t samples = 0, bytes = 0, lost = 0, all = 0;
    SteadyTime first = now;
    std::optional<std::chrono::nanoseconds> transit;
    for (const Count& count : m_counts) {
        const std::int64_t back = slotOf(now) - count.slot;
        if (count.slot < 0 || back >= Slots) continue;
        lost += count.lost;
        all += count.samples + count.lost;
        if (back <= 1 && count.transit) transit = std::min(transit.value_or(*count.transit), *count.transit);
        if (back >= RateSlots) continue;
        samples += count.samples;
        bytes += count.bytes;
        first = std::min(first, count.first);
    }
    if (transit) figures.transit = transit;
    figures.lossBasis = all;
    if (all > 0) figures.lossRatio = static_cast<double>(lost) / static_cast<double>(all);
    if (samples == 0) return figures;
    const double number = static_cast<double>(samples);
    const double spoken = toSeconds(m_newest - first);  // from the first to the newest
    const double usual = samples > 1 ? spoken / (number - 1.0) : toSeconds(RateSlots * Slot);
    if (spoken > 0.0 && figures.age <= 2.0 * usual) {
        figures.rate = 1.0 / usual;
    } else {  // a burst, a single one, or silence since
        figures.rate =
            number / std::max(toSeconds(samples > 1 ? Slot : RateSlots * Slot), toSeconds(now - first));
    }
    figures.megabitsPerSecond = figures.rate * 8e-6 * static_cast<double>(bytes) / number;
    return figures;
}

std::optional<double> StreamMonitor::interval() const {
    if (m_intervals < Learned || m_interval <= 0.0) return std::nullopt;
    return m_interval;
}

}  // namespace leitstand
