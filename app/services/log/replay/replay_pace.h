#pragma once

#include <chrono>

#include "core/base/time.h"

namespace leitstand {

/// Computes how long a replay waits before it publishes the next event, from the times at which events were
/// received. These times may be anything: 1970, 2262, back and forth.
class ReplayPace {
public:
    /// Longest wait. A longer gap is between sessions, or comes from a time that makes no sense; then the
    /// wait is one second.
    static constexpr std::chrono::hours MostSilence{1};

    /// Returns the wait before an event that was received at @p received. @p begins: the event is the first
    /// of a session. Since the station was off before it, the wait is then at most one second.
    [[nodiscard]] std::chrono::nanoseconds waitBefore(Time received, bool begins);

private:
    bool m_any = false;
    Time m_before{};  // latest receive time that fits the one before it
};

}  // namespace leitstand
