#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace leitstand::test {

/// What a finished process left.
struct ProcessOutcome {
    int exitCode = -1;  ///< -1 when it was killed by a signal
    std::string out, err;
};

/// Runs @p program with @p arguments to its end, its output kept apart.
[[nodiscard]] ProcessOutcome runProcess(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments);

/// Runs it, and sends SIGINT @p milliseconds after the start (a process that has ended by then is left
/// alone).
[[nodiscard]] ProcessOutcome runAndInterrupt(const std::filesystem::path& program,
                                             const std::vector<std::string>& arguments, int milliseconds);

}  // namespace leitstand::test
