#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

namespace leitstand {

/// While it lives, @p what is done in a process that was asked to end and hangs
/// (InterruptGuard::End::Surely), in a thread of its own, before the process is ended all the same: a log is
/// closed, say. Any thread.
class WhenLate {
public:
    explicit WhenLate(std::function<void()> what);
    ~WhenLate();  ///< waits while it is being done
    WhenLate(const WhenLate&) = delete;
    WhenLate& operator=(const WhenLate&) = delete;
};

/// While it lives, the first Ctrl-C (SIGINT), SIGTERM or SIGHUP asks the work to stop instead of ending the
/// process; one that comes half a second later or more ends it, but for SIGHUP, which comes twice when a
/// terminal closes. What comes sooner is the same wish. One that was ignored before, as nohup wants SIGHUP,
/// stays so. At most one guard at a time.
class InterruptGuard {
public:
    enum class End : std::uint8_t {
        Orderly,  ///< however long the work takes
        /// Within 5 s of the signal, whatever threads of libraries do: what is to be done WhenLate is done
        /// after 3 s, and the process ends with 1. Stays so when the guard is gone.
        Surely,
    };
    explicit InterruptGuard(End end = End::Orderly);
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
