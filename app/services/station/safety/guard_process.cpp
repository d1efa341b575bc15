#include "app/services/station/safety/guard_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <string_view>
#include <system_error>
#include <thread>

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/words.h"
#include "transport/link/drive_guard.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

constexpr auto Hangs = 2s;       ///< without a message; two come each second
constexpr auto EndsWithin = 5s;  ///< two seconds of zeros, and leaving the domain

Error notStarted(const std::filesystem::path& program, int problem) {
    return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be started: {}"), program.string(),
                                 std::strerror(problem))};
}

/// Starts the program with @p pipe as its standard input; 0 or an error number.
int spawn(pid_t& id, const std::filesystem::path& program, const std::vector<std::string>& words, int pipe) {
    std::vector<std::string> all = {program.string()};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> argv;
    for (std::string& word : all) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, pipe, STDIN_FILENO);
    // Our other files, which their openers may have left inheritable, are not for the guard.
    posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    // A group of its own: what a terminal sends to the station, such as Ctrl-Z, is not for the guard.
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    const int problem = posix_spawn(&id, program.c_str(), &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return problem;
}

}  // namespace

Result<std::unique_ptr<GuardProcess>> GuardProcess::start(const std::filesystem::path& program,
                                                          const std::vector<std::string>& words) {
    // Both ends are closed in all other processes that this one starts. A process that held ours open would
    // keep the guard from noticing that we died.
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return notStarted(program, errno);
    pid_t id = -1;
    const int problem = spawn(id, program, words, ends[1]);
    close(ends[1]);
    if (problem != 0) {
        close(ends[0]);
        return notStarted(program, problem);
    }
    return std::unique_ptr<GuardProcess>(new GuardProcess(id, ends[0]));
}

GuardProcess::~GuardProcess() {
    close(m_pipe);
    const auto end = std::chrono::steady_clock::now() + EndsWithin;
    while (waitpid(m_id, nullptr, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() >= end) kill();
        std::this_thread::sleep_for(5ms);
    }
}

bool GuardProcess::pulse(const GuardPulse& pulse) const {
    const std::string text = toString(pulse);
    return send(m_pipe, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
           static_cast<ssize_t>(text.size());
}

bool GuardProcess::isReady(SteadyTime now) const {
    return m_ready && now - m_received < Hangs;
}

void GuardProcess::kill() const {
    ::kill(m_id, SIGKILL);
}

bool GuardProcess::read() {
    std::array<char, 64> text{};
    for (;;) {
        const ssize_t size = recv(m_pipe, text.data(), text.size(), MSG_DONTWAIT);
        if (size < 0 && errno == EINTR) continue;
        if (size < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
        if (size == 0) return false;
        m_received = std::chrono::steady_clock::now();
        m_ready = std::string_view(text.data(), static_cast<std::size_t>(size)) == guard_word::Ready;
    }
}

std::filesystem::path guardProgram() {
    std::error_code problem;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", problem);
    return program.parent_path() / "leitstand-guard";
}

}  // namespace leitstand
