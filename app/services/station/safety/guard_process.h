#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/robot/control/stop/guard_rules.h"

namespace leitstand {

/// A leitstand-guard process beside this process, and the pipe to it. The guard ends by itself when the pipe
/// closes, whatever happens to this process. For one thread, except for pulse().
class GuardProcess {
public:
    /// Starts the program file @p program with the arguments @p words. Error when it cannot be started.
    [[nodiscard]] static Result<std::unique_ptr<GuardProcess>> start(const std::filesystem::path& program,
                                                                     const std::vector<std::string>& words);
    /// Closes the pipe and waits until the guard ends: at once if nobody drives, otherwise 5 s.
    ~GuardProcess();
    GuardProcess(const GuardProcess&) = delete;
    GuardProcess& operator=(const GuardProcess&) = delete;

    /// Sends @p pulse to the guard. Returns false when the guard does not take it. Never waits. Any thread.
    bool pulse(const GuardPulse& pulse) const;
    /// Can be polled: readable when read() has something new.
    [[nodiscard]] int pipe() const { return m_pipe; }
    /// Takes the guard's messages since the last call. Returns false when the guard has ended.
    [[nodiscard]] bool read();
    /// Whether the guard has recently reported that the robot receives its commands; so it does not hang.
    [[nodiscard]] bool isReady(SteadyTime now) const;
    void kill() const;
    [[nodiscard]] pid_t id() const { return m_id; }

private:
    GuardProcess(pid_t id, int pipe) : m_id(id), m_pipe(pipe) {}

    const pid_t m_id;
    const int m_pipe;
    bool m_ready = false;
    SteadyTime m_received = {};
};

/// Returns the path of the guard program: it is built and installed in the same folder as the running
/// program.
[[nodiscard]] std::filesystem::path guardProgram();

}  // namespace leitstand
