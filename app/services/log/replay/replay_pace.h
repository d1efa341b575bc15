#pragma once

#include <chrono>

#include "core/base/time.h"

namespace leitstand {

/// Computes how long a replay waits before it publishes the next event, by the times at which the log
/// received them. Those may be anything: 1970, 2262, back and forth.
class ReplayPace {
public:
    /// No wait is longer than this. Such a gap lies between sessions, or is a time that makes no sense; it
    /// lasts a second.
    static constexpr std::chrono::hours MostSilence{1};

    /// Returns the wait before an event received at @p received. @p begins: it is the first of a session,
    /// before which the station was off.
    [[nodiscard]] std::chrono::nanoseconds waitBefore(Time received, bool begins);

private:
    bool m_any = false;
    Time m_before{};  // the latest that makes sense together with the one before
};

}  // namespace leitstand
