#pragma once

#include <stop_token>

namespace leitstand::cli {

/// While it lives, the first Ctrl-C (SIGINT) or SIGTERM asks the work to stop instead of ending the process;
/// a second one ends it. At most one at a time.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Stops when the signal has come.
    [[nodiscard]] std::stop_token token() const;
};

}  // namespace leitstand::cli
