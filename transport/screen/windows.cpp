#include "transport/screen/windows.h"

#include <algorithm>

#include "core/event/sample.h"

namespace leitstand::screen {

bool CountWindow::admits(std::uint32_t count, bool leads, Moment now) {
    if (!leads) return m_known && count <= std::uint64_t(m_highest) + limits::Beside;
    if (!m_known) {
        m_known = true;
        m_highest = count;
        return true;
    }
    if (count <= m_highest) return true;
    if (!m_budget.take(double(count - m_highest), now, limits::Counts)) return false;
    m_highest = count;
    return true;
}

bool WriterWindow::admitNumber(std::int64_t number, bool leads, Moment now) {
    if (number > limits::MostNumber) return false;
    if (!leads) return m_known && number <= m_highest + limits::Beside;
    if (m_known && number <= m_highest) return true;
    if (m_known && !m_numbers.take(double(number - m_highest), now, limits::Numbers)) return false;
    m_known = true;
    m_highest = number;
    return true;
}

Fault WriterWindow::admitFragment(const Submessage& next, bool leads, Budget& unfinished, Moment now) {
    constexpr std::size_t Remembered = 32;
    if (next.sampleSize > limits::LargestSample) return "a sample that is too large";
    const auto known = std::find_if(m_samples.begin(), m_samples.end(),
                                    [&](const Sample& one) { return one.number == next.first; });
    if (known == m_samples.end() && !leads) return "fragments of a sample that the writer did not begin";
    if (leads) unfinished.giveBack(double(next.payload.size()), limits::UnfinishedSamples);
    if (known != m_samples.end()) {
        const bool same = known->size == next.sampleSize && known->fragmentSize == next.fragmentSize;
        return same ? Fault{} : "fragments of one sample that do not fit each other";
    }
    if (!unfinished.take(next.sampleSize, now, limits::UnfinishedSamples)) return "too much in fragments";
    if (m_samples.size() < Remembered) m_samples.emplace_back();
    m_samples[m_nextSample] = {next.first, next.sampleSize, next.fragmentSize};
    m_nextSample = (m_nextSample + 1) % Remembered;
    return {};
}

Fault WriterWindow::admit(const Submessage& next, bool leads, Budget& unfinished, Moment now) {
    constexpr Fault Jump = "a number that the writer cannot have reached";
    switch (next.kind) {
        case Kind::Data:
            return admitNumber(next.first, leads, now) ? Fault{} : Jump;
        case Kind::DataFrag:
            return admitNumber(next.first, leads, now) ? admitFragment(next, leads, unfinished, now) : Jump;
        case Kind::Heartbeat:
            if (!admitNumber(std::max(next.first, next.last), leads, now)) return Jump;
            return m_heartbeats.admits(next.count, leads, now) ? Fault{} : "a count of HEARTBEAT that jumps";
        case Kind::HeartbeatFrag:
            if (!admitNumber(next.first, leads, now)) return Jump;
            return m_fragmentHeartbeats.admits(next.count, leads, now)
                       ? Fault{}
                       : "a count of HEARTBEAT_FRAG that jumps";
        case Kind::Gap:
            if (next.gapped > limits::LongestGap) return "a GAP that is too long";
            if (!leads && next.gapped > limits::Beside) return "a GAP that is too long";
            // Checked first: a GAP that is refused for this does not advance the numbers.
            if (leads && !m_gaps.take(double(next.gapped), now, limits::Gaps))
                return "GAPs that cover too much";
            return admitNumber(next.last, leads, now) ? Fault{} : Jump;
        default:
            return {};
    }
}

}  // namespace leitstand::screen
