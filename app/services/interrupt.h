#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

namespace leitstand {

/// While it lives, runs @p what when the process was asked to end and hangs (InterruptGuard::End::Surely),
/// for example to close a log. Runs it on its own thread before the process is ended anyway. Any thread.
class WhenLate {
public:
    explicit WhenLate(std::function<void()> what);
    ~WhenLate();  ///< waits while @p what runs
    WhenLate(const WhenLate&) = delete;
    WhenLate& operator=(const WhenLate&) = delete;
};

/// While it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP requests the work to stop instead of ending
/// the process. A signal half a second later or more ends the process, except SIGHUP, which comes twice when
/// a terminal closes. An earlier signal counts as the same request. A signal that was ignored before stays
/// ignored (nohup ignores SIGHUP). At most one guard at a time.
class InterruptGuard {
public:
    enum class End : std::uint8_t {
        Orderly,  ///< however long the work takes
        /// Within 5 s of the signal, even when threads of libraries hang. Actions of WhenLate run after 3 s,
        /// and the process ends with status 1. Stays in force when the guard is gone.
        Surely,
    };
    explicit InterruptGuard(End end = End::Orderly);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Its stop is requested when the signal has come, on a thread of the guard.
    [[nodiscard]] std::stop_token token() const { return m_source.get_token(); }

private:
    std::stop_source m_source;
    std::thread m_waiter;
};

}  // namespace leitstand
