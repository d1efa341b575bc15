#include "app/services/log/replay/replay_pace.h"

#include <algorithm>

namespace leitstand {
namespace {

using std::chrono::nanoseconds;
constexpr std::chrono::seconds Short(1);  ///< wait for a gap that is too long

/// Whether @p later is more than MostSilence after @p earlier; neither sum nor difference may overflow.
bool farAfter(Time later, Time earlier) {
    return earlier <= Time::max() - ReplayPace::MostSilence && later > earlier + ReplayPace::MostSilence;
}

}  // namespace

nanoseconds ReplayPace::waitBefore(Time received, bool begins) {
    if (!m_any) {
        m_any = true;
        m_before = received;
        return nanoseconds(0);
    }
    if (farAfter(received, m_before)) {
        m_before = received;
        return Short;
    }
    if (farAfter(m_before, received)) {
        m_before = received;
        return nanoseconds(0);
    }
    const nanoseconds gap = std::max(received - m_before, nanoseconds(0));
    m_before = std::max(m_before, received);
    return begins ? std::min<nanoseconds>(gap, Short) : gap;
}

}  // namespace leitstand
