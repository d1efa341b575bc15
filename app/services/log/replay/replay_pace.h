#pragma once

#include <chrono>

#include "core/base/time.h"

namespace leitstand {

/// How long a replay waits before it says the next event, by the times at which the log received them. Those
/// may be anything: 1970, 2262, back and forth.
class ReplayPace {
public:
    /// Nobody waits longer than this for what a log says next [s]: such a gap is one between sessions, or a
    /// time that makes no sense, and lasts a second.
    static constexpr std::chrono::hours MostSilence{1};

    /// The wait before an event received at @p received. @p begins: it is the first of a session, before
    /// which the station was off.
    [[nodiscard]] std::chrono::nanoseconds waitBefore(Time received, bool begins);

private:
    bool m_any = false;
    Time m_before{};  // the latest that makes sense together with the one before
};

}  // namespace leitstand
