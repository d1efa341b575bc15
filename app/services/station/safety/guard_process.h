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

/// A leitstand-guard that runs beside this process, and the pipe to it. It ends by itself when the pipe
/// closes, whatever happens to this process. One thread, except for pulse().
class GuardProcess {
public:
    /// Starts @p program, its file, with @p words on its command line. Error when it cannot be started.
    [[nodiscard]] static Result<std::unique_ptr<GuardProcess>> start(const std::filesystem::path& program,
                                                                     const std::vector<std::string>& words);
    ~GuardProcess();  ///< closes the pipe and waits for its end, which is immediate when nobody drives
    GuardProcess(const GuardProcess&) = delete;
    GuardProcess& operator=(const GuardProcess&) = delete;

    /// Sends it @p pulse; false when it does not take it. Never waits. Any thread.
    bool pulse(const GuardPulse& pulse) const;
    [[nodiscard]] int pipe() const { return m_pipe; }  ///< readable when read() has something new
    /// Takes its messages since the last call. False when it has ended.
    [[nodiscard]] bool read();
    /// Whether its last message reports that the robot receives it, and is recent: the guard does not hang.
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

/// Returns the guard beside the running program: where programs are installed, and where they are built.
[[nodiscard]] std::filesystem::path guardProgram();

}  // namespace leitstand
