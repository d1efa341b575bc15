#include "widgets/models/timeline/timeline_axis.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "core/base/time.h"

namespace leitstand {
namespace {

constexpr double GapShare = 0.02;  ///< of the recorded time, each gap

std::chrono::nanoseconds nanosecondsOf(double seconds) {
    return std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

}  // namespace

TimelineAxis::TimelineAxis(std::vector<TimelineStretch> stretches) {
    double recorded = 0.0;
    for (const TimelineStretch& one : stretches) recorded += toSeconds(one.to - one.from);
    const double least = std::max(recorded, 1e-3);  // a mission of a single moment has an axis, too
    const double gap = GapShare * least;
    const double whole = least + gap * (static_cast<double>(stretches.size()) - 1.0);
    double done = 0.0;
    for (const TimelineStretch& one : stretches) {
        const double length = recorded > 0.0 ? toSeconds(one.to - one.from) : least;
        m_parts.push_back({one, done / whole, std::min(1.0, (done + length) / whole)});
        done += length + gap;
    }
    if (!m_parts.empty()) m_parts.back().to = 1.0;
}

Time TimelineAxis::first() const {
    return m_parts.empty() ? Time{} : m_parts.front().stretch.from;
}

Time TimelineAxis::last() const {
    return m_parts.empty() ? Time{} : m_parts.back().stretch.to;
}

double TimelineAxis::placeOf(Time at) const {
    double before = 0.0;
    for (const Part& part : m_parts) {
        if (at < part.stretch.from)
            return m_parts.front().stretch.from > at ? 0.0 : 0.5 * (before + part.from);
        if (at <= part.stretch.to) {
            const double length = toSeconds(part.stretch.to - part.stretch.from);
            const double share = length > 0.0 ? toSeconds(at - part.stretch.from) / length : 0.0;
            return part.from + share * (part.to - part.from);
        }
        before = part.to;
    }
    return m_parts.empty() ? 0.0 : 1.0;
}

Time TimelineAxis::timeAt(double place) const {
    if (m_parts.empty()) return {};
    if (!(place > 0.0)) return first();
    const Part* before = nullptr;
    for (const Part& part : m_parts) {
        if (place < part.from) {
            const bool nearer = before != nullptr && place - before->to < part.from - place;
            return nearer ? before->stretch.to : part.stretch.from;
        }
        if (place <= part.to && part.to > part.from) {
            const double share = (place - part.from) / (part.to - part.from);
            return part.stretch.from + nanosecondsOf(share * toSeconds(part.stretch.to - part.stretch.from));
        }
        before = &part;
    }
    return last();
}

std::chrono::nanoseconds TimelineAxis::recordedUntil(Time at) const {
    std::chrono::nanoseconds recorded{};
    for (const Part& part : m_parts) {
        if (at <= part.stretch.from) break;
        recorded += std::min(at, part.stretch.to) - part.stretch.from;
    }
    return recorded;
}

std::vector<std::pair<double, double>> TimelineAxis::gaps() const {
    std::vector<std::pair<double, double>> gaps;
    for (std::size_t i = 1; i < m_parts.size(); ++i) gaps.emplace_back(m_parts[i - 1].to, m_parts[i].from);
    return gaps;
}

std::vector<TimelineAxis::Tick> TimelineAxis::ticks(double apart) const {
    static constexpr std::array Steps = {1,   2,   5,    10,   15,   30,    60,    120,  300,
                                         600, 900, 1800, 3600, 7200, 14400, 43200, 86400};
    std::vector<Tick> ticks;
    if (m_parts.empty() || !(apart > 0.0)) return ticks;
    double recorded = 0.0;
    for (const Part& part : m_parts) recorded += toSeconds(part.stretch.to - part.stretch.from);
    const auto found =
        std::find_if(Steps.begin(), Steps.end(), [&](int step) { return step >= apart * recorded; });
    const auto step = std::chrono::seconds(found == Steps.end() ? Steps.back() : *found);
    for (const Part& part : m_parts) {
        const auto since = part.stretch.from.time_since_epoch();
        Time at(since - since % step);
        if (at < part.stretch.from) at += step;
        for (; at <= part.stretch.to; at += step) {
            const double place = placeOf(at);
            if (ticks.empty() || place - ticks.back().place >= 0.9 * apart) ticks.push_back({at, place});
        }
    }
    return ticks;
}

}  // namespace leitstand
