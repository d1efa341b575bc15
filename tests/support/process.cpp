#include "tests/support/process.h"

#include <array>
#include <chrono>
#include <csignal>
#include <ctime>
#include <functional>
#include <limits>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace leitstand::test {
namespace {

std::string readAll(int descriptor) {
    std::string text;
    std::array<char, 4096> chunk{};
    for (ssize_t n = 0; (n = read(descriptor, chunk.data(), chunk.size())) > 0;) {
        text.append(chunk.data(), static_cast<std::size_t>(n));
    }
    close(descriptor);
    return text;
}

ProcessOutcome run(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   const std::function<void(pid_t)>& whileRunning) {
    std::array<int, 2> out{}, err{};
    if (pipe(out.data()) != 0 || pipe(err.data()) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        dup2(out[1], STDOUT_FILENO);
        dup2(err[1], STDERR_FILENO);
        for (const int end : {out[0], out[1], err[0], err[1]}) close(end);
        std::vector<std::string> words = {program.string()};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        execv(argv[0], argv.data());
        _exit(127);
    }
    close(out[1]);
    close(err[1]);
    ProcessOutcome outcome;
    {
        std::jthread readsErrors([&] { outcome.err = readAll(err[0]); });
        std::jthread acts([&] {
            if (whileRunning) whileRunning(child);
        });
        outcome.out = readAll(out[0]);
    }
    int status = 0;
    waitpid(child, &status, 0);
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

}  // namespace

double secondsUsedBy(pid_t child) {
    clockid_t clock{};
    timespec used{};
    siginfo_t ended{};
    const bool gone = waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
                      ended.si_pid == child;
    if (gone || clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &used) != 0) {
        return std::numeric_limits<double>::infinity();
    }
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

ProcessOutcome runProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    return run(program, arguments, {});
}

ProcessOutcome runAndInterrupt(const std::filesystem::path& program,
                               const std::vector<std::string>& arguments, double processorSeconds) {
    return run(program, arguments, [processorSeconds](pid_t child) {
        while (secondsUsedBy(child) < processorSeconds) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        kill(child, SIGINT);
    });
}

}  // namespace leitstand::test
