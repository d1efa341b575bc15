#pragma once

#include <stop_token>
#include <thread>

namespace leitstand {

/// While it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP asks the work to stop instead of ending the
/// process; a second one ends it, but for SIGHUP, which comes twice when a terminal closes. One that was
/// ignored before, as nohup wants SIGHUP, stays so. At most one guard at a time.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Stops when the signal has come, in a thread of the guard's.
    [[nodiscard]] std::stop_token token() const { return m_source.get_token(); }

private:
    std::stop_source m_source;
    std::thread m_waiter;
};

}  // namespace leitstand
