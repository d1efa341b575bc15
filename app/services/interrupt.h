#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

namespace leitstand {

/// Runs @p what if, during the life of this object, the process is asked to end and hangs
/// (InterruptGuard::End::Surely), for example to close a log. Runs it on a separate thread before the process
/// is ended by force. Any thread.
class WhenLate {
public:
    explicit WhenLate(std::function<void()> what);
    ~WhenLate();  ///< waits while @p what runs
    WhenLate(const WhenLate&) = delete;
    WhenLate& operator=(const WhenLate&) = delete;
};

/// While it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP requests the work to stop instead of ending
/// the process. Further signals within half a second count as the same request. A later one ends the process,
/// except SIGHUP, which comes twice when a terminal closes. A signal that was ignored before stays ignored
/// (nohup ignores SIGHUP). At most one guard at a time.
class InterruptGuard {
public:
    enum class End : std::uint8_t {
        Orderly,  ///< however long the work takes
        /// Within 5 s of the signal, even when threads of libraries hang. After 3 s the actions of WhenLate
        /// run, then the process ends with status 1. Stays in force after the guard is destroyed.
        Surely,
    };
    explicit InterruptGuard(End end = End::Orderly);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Returns the token whose stop is requested, on a thread of the guard, when the signal has come.
    [[nodiscard]] std::stop_token token() const { return m_source.get_token(); }

private:
    std::stop_source m_source;
    std::thread m_waiter;
};

}  // namespace leitstand
