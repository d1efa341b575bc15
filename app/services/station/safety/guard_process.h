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

/// A leitstand-guard that runs beside this process, and the pipe to it. The guard ends by itself when the
/// pipe closes, whatever happens to this process. For one thread, except for pulse().
class GuardProcess {
public:
    /// Starts the program file @p program with the arguments @p words. Error when it cannot be started.
    [[nodiscard]] static Result<std::unique_ptr<GuardProcess>> start(const std::filesystem::path& program,
                                                                     const std::vector<std::string>& words);
    ~GuardProcess();  ///< closes the pipe and waits until the guard ends: at once if nobody drives, else 5 s
    GuardProcess(const GuardProcess&) = delete;
    GuardProcess& operator=(const GuardProcess&) = delete;

    /// Sends @p pulse to the guard; false when the guard does not take it. Never waits. Any thread.
    bool pulse(const GuardPulse& pulse) const;
    [[nodiscard]] int pipe() const { return m_pipe; }  ///< readable when read() has something new
    /// Takes the messages of the guard since the last call; false when the guard has ended.
    [[nodiscard]] bool read();
    /// Whether the guard reports that the robot receives it, and has done so recently: it does not hang.
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

/// Returns the path of the guard, in the folder of the running program, where it is both built and installed.
[[nodiscard]] std::filesystem::path guardProgram();

}  // namespace leitstand
