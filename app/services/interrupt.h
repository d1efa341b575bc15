#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

namespace leitstand {

/// Runs @p what if the process is asked to end and hangs (InterruptGuard::End::Surely) while this object
/// exists; for example to close a log. Runs it on a separate thread before the process is ended by force. Any
/// thread.
class WhenLate {
public:
    explicit WhenLate(std::function<void()> what);
    ~WhenLate();  ///< waits while @p what is running
    WhenLate(const WhenLate&) = delete;
    WhenLate& operator=(const WhenLate&) = delete;
};

/// While it exists, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP requests the work to stop, instead of ending
/// the process. Further signals within half a second are ignored. A later one ends the process, except
/// SIGHUP, which is sent twice when a terminal closes. A signal that was ignored before is still ignored
/// (nohup ignores SIGHUP). At most one guard at a time.
class InterruptGuard {
public:
    enum class End : std::uint8_t {
        Orderly,  ///< the work may take any time
        /// Within 5 s after the signal, even if threads of libraries hang. After 3 s the actions of WhenLate
        /// are run, then the process ends with status 1. Remains in force after the guard is destroyed.
        Surely,
    };
    explicit InterruptGuard(End end = End::Orderly);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Returns a token; its stop is requested on a thread of the guard when a signal has arrived.
    [[nodiscard]] std::stop_token token() const { return m_source.get_token(); }

private:
    std::stop_source m_source;
    std::thread m_waiter;
};

}  // namespace leitstand
