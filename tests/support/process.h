#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace leitstand::test {

/// What a finished process left.
struct ProcessOutcome {
    int exitCode = -1;  ///< -1 when it was killed by a signal
    std::string out, err;
};

/// Runs @p program with @p arguments to its end, its output kept apart.
[[nodiscard]] ProcessOutcome runProcess(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments);

/// Runs it, and sends SIGINT once it has computed for @p processorSeconds of its own processor time, however
/// busy the machine is (a process that has ended by then is left alone).
[[nodiscard]] ProcessOutcome runAndInterrupt(const std::filesystem::path& program,
                                             const std::vector<std::string>& arguments,
                                             double processorSeconds);

/// Processor time that @p child, a process of this one's, has used [s]; infinite once it has ended.
[[nodiscard]] double secondsUsedBy(pid_t child);

}  // namespace leitstand::test
