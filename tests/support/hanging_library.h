#pragma once

#include <chrono>
#include <vector>

#include <sys/types.h>

namespace leitstand::test {

/// Makes threads of a library hang in another process for as long as this lives, as one that waits for a lock
/// for ever: those that receive from the network, which whoever leaves a domain waits for. A thread that is
/// busy with what it received is taken when it receives again; two at least, unless 10 s do not show them. Of
/// a child of this process; to be used by one thread.
class HangingLibrary {
public:
    explicit HangingLibrary(pid_t process);
    ~HangingLibrary();  ///< lets go of those that still hang
    HangingLibrary(const HangingLibrary&) = delete;
    HangingLibrary& operator=(const HangingLibrary&) = delete;

    [[nodiscard]] std::size_t threads() const { return m_threads.size(); }
    /// Whether the process has let go of them all by ending, after @p atMost at the latest.
    [[nodiscard]] bool endsWithin(std::chrono::milliseconds atMost);

private:
    void takeThoseThatReceive(pid_t process);

    std::vector<pid_t> m_threads;
};

}  // namespace leitstand::test
