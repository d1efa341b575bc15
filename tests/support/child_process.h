#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <sys/types.h>

namespace leitstand::test {

/// A program that runs beside the test; killed, if it still runs, at the end of the test.
class ChildProcess {
public:
    /// @p environment: "NAME=value", beside the test's own.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment = {});
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void signal(int number) const;
    int wait();                             ///< until it ends: its exit code, -1 when a signal ended it
    [[nodiscard]] std::string out() const;  ///< what it has said so far, errors too
    [[nodiscard]] pid_t id() const { return m_id; }

private:
    pid_t m_id = -1;
    int m_exitCode = -1;
    bool m_ended = false;
    mutable std::mutex m_mutex;
    std::string m_out;
    std::jthread m_reading;
};

}  // namespace leitstand::test
