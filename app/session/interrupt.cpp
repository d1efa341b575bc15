#include "app/session/interrupt.h"

#include <array>
#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace leitstand {
namespace {

using Action = struct sigaction;

struct Taken {
    int signal;
    Action before = {};
};

constexpr char End = 0, Came = 1;  // what the pipe says

// request_stop is not allowed in a signal handler, so the handler writes to a pipe and a thread stops the
// work. The pipe stays open: a handler may be at work in another thread when a guard goes.
std::array<Taken, 3> signals = {{{.signal = SIGINT}, {.signal = SIGTERM}, {.signal = SIGHUP}}};
std::array<int, 2> wakeUp = {-1, -1};

Action handledBy(void (*handler)(int)) {
    Action action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    return action;
}

void giveBack() {
    for (const Taken& one : signals) sigaction(one.signal, &one.before, nullptr);
}

void say(char what) {
    [[maybe_unused]] const auto written = write(wakeUp[1], &what, 1);
}

/// What the pipe says next.
char heard() {
    char byte = End;
    while (read(wakeUp[0], &byte, 1) < 0 && errno == EINTR) {
    }
    return byte;
}

void onSignal(int /*signal*/) {
    const int error = errno;
    giveBack();
    const Action ignored = handledBy(SIG_IGN);
    sigaction(SIGHUP, &ignored, nullptr);
    say(Came);
    errno = error;
}

/// Opens the pipe, or takes out what a handler said too late for the guard before.
bool openPipe() {
    if (wakeUp[0] < 0) return pipe2(wakeUp.data(), O_CLOEXEC) == 0;
    int waiting = 0;
    while (ioctl(wakeUp[0], FIONREAD, &waiting) == 0 && waiting > 0) heard();
    return true;
}

}  // namespace

InterruptGuard::InterruptGuard() {
    if (!openPipe()) return;  // Ctrl-C then ends the process at once
    // A copy: the guard does not go where a library ends the process by exit().
    m_waiter = std::thread([source = m_source]() mutable {
        if (heard() == Came) source.request_stop();
    });
    const Action action = handledBy(onSignal);
    for (Taken& one : signals) sigaction(one.signal, nullptr, &one.before);
    for (const Taken& one : signals) {
        if (one.before.sa_handler != SIG_IGN) sigaction(one.signal, &action, nullptr);
    }
}

InterruptGuard::~InterruptGuard() {
    if (!m_waiter.joinable()) return;
    giveBack();
    say(End);
    m_waiter.join();
}

}  // namespace leitstand
