#include "tests/support/hanging_library.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

/// Whether a thread waits for what comes from the network.
bool receives(const std::filesystem::path& thread) {
    long call = -1;
    std::ifstream(thread / "syscall") >> call;
    return call == SYS_recvfrom || call == SYS_recvmsg;
}

}  // namespace

HangingLibrary::HangingLibrary(pid_t process) {
    std::ignore = waitUntil(
        [&] {
            takeThoseThatReceive(process);
            return m_threads.size() > 1;
        },
        std::chrono::seconds(10));
}

HangingLibrary::~HangingLibrary() {
    for (const pid_t thread : m_threads) ptrace(PTRACE_DETACH, thread, nullptr, nullptr);
}

void HangingLibrary::takeThoseThatReceive(pid_t process) {
    const std::string tasks = "/proc/" + std::to_string(process) + "/task";
    for (const auto& entry : std::filesystem::directory_iterator(tasks)) {
        const pid_t thread = std::stoi(entry.path().filename().string());
        if (std::find(m_threads.begin(), m_threads.end(), thread) != m_threads.end()) continue;
        if (!receives(entry.path()) || ptrace(PTRACE_SEIZE, thread, nullptr, nullptr) != 0) continue;
        ptrace(PTRACE_INTERRUPT, thread, nullptr, nullptr);
        int status = 0;
        waitpid(thread, &status, __WALL);
        m_threads.push_back(thread);
    }
}

bool HangingLibrary::endsWithin(std::chrono::milliseconds atMost) {
    return waitUntil(
        [&] {
            std::erase_if(m_threads, [](pid_t thread) {
                int status = 0;
                const pid_t received = waitpid(thread, &status, __WALL | WNOHANG);
                return received == thread && (WIFEXITED(status) || WIFSIGNALED(status));
            });
            return m_threads.empty();
        },
        atMost);
}

}  // namespace leitstand::test
