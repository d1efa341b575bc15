#include "tests/support/child_process.h"

#include <array>
#include <csignal>
#include <cstdlib>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace leitstand::test {

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           const std::vector<std::string>& environment) {
    std::vector<std::string> words = {program.string()}, variables = environment;
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    std::vector<std::string> ros;  // of whoever runs the tests: they say where the robots are by options
    for (char** one = environ; *one != nullptr; ++one) {
        const std::string variable = *one;
        if (variable.starts_with("ROS_")) ros.push_back(variable.substr(0, variable.find('=')));
    }
    std::array<int, 2> out{};
    if (pipe(out.data()) != 0) return;
    m_id = fork();
    if (m_id == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (const std::string& variable : ros) unsetenv(variable.c_str());
        for (std::string& variable : variables) putenv(variable.data());
        dup2(out[1], STDOUT_FILENO);
        dup2(out[1], STDERR_FILENO);
        close(out[0]);
        close(out[1]);
        execv(argv[0], argv.data());
        _exit(127);
    }
    close(out[1]);
    m_reading = std::jthread([this, end = out[0]] {
        std::array<char, 4096> chunk{};
        for (ssize_t n = 0; (n = read(end, chunk.data(), chunk.size())) > 0;) {
            const std::scoped_lock lock(m_mutex);
            m_out.append(chunk.data(), static_cast<std::size_t>(n));
        }
        close(end);
    });
}

ChildProcess::~ChildProcess() {
    if (!m_ended) signal(SIGKILL);
    wait();
}

void ChildProcess::signal(int number) const {
    if (m_id > 0 && !m_ended) kill(m_id, number);
}

int ChildProcess::wait() {
    int status = 0;
    if (m_ended || m_id <= 0 || waitpid(m_id, &status, 0) != m_id) return m_exitCode;
    m_ended = true;
    m_exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (m_reading.joinable()) m_reading.join();
    return m_exitCode;
}

std::string ChildProcess::out() const {
    const std::scoped_lock lock(m_mutex);
    return m_out;
}

}  // namespace leitstand::test
