#include "app/services/interrupt.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <mutex>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/time.h>
#include <unistd.h>

namespace leitstand {
namespace {

using Action = struct sigaction;

struct Taken {
    int signal;
    Action before = {};
};

constexpr char GuardGone = 0, Came = 1;  // messages in the pipe

// request_stop is not allowed in a signal handler, so the handler writes to a pipe and a thread stops the
// work. The pipe stays open: a handler may run on another thread when a guard is destroyed.
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

void putByte(char what) {
    [[maybe_unused]] const auto written = write(wakeUp[1], &what, 1);
}

/// Reads the next message from the pipe.
char takeByte() {
    char byte = GuardGone;
    while (read(wakeUp[0], &byte, 1) < 0 && errno == EINTR) {
    }
    return byte;
}

// Time of the first signal since the system started [ns]; 0: none came.
std::atomic<std::int64_t> firstAt = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

/// Within that time all signals are one request: `timeout` signals the process, then its group.
constexpr std::chrono::nanoseconds OneRequest = std::chrono::milliseconds(500);

/// Allowed in a signal handler, unlike the clocks of std.
std::int64_t sinceStart() {
    timespec now = {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

void ignoreHangUps() {
    const Action ignored = handledBy(SIG_IGN);
    sigaction(SIGHUP, &ignored, nullptr);
}

void onSignal(int signal) {
    const int error = errno;
    std::int64_t first = 0;
    const std::int64_t now = sinceStart();
    if (firstAt.compare_exchange_strong(first, now)) {
        ignoreHangUps();
        putByte(Came);
    } else if (now - first >= OneRequest.count()) {
        giveBack();
        ignoreHangUps();
        raise(signal);  // delivered when this handler returns
    }
    errno = error;
}

/// Actions for a process that does not end. Never destroyed: its process may hang in exit().
struct Late {
    std::mutex mutex;
    std::map<const WhenLate*, std::function<void()>> all;
};
Late& late() {
    static auto* const one = new Late;
    return *one;
}

using Clock = std::chrono::steady_clock;
constexpr auto LateAfter = std::chrono::milliseconds(3000), EndAfter = std::chrono::milliseconds(4200);

/// Whether the guard is gone by @p until.
bool endsBy(Clock::time_point until) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd pipe = {.fd = wakeUp[0], .events = POLLIN, .revents = 0};
    return poll(&pipe, 1, static_cast<int>(std::max<long long>(left, 0))) > 0;
}

/// Makes the system end the process, whatever happens.
void endAtTheLatest() {
    itimerval timer = {};
    timer.it_value = {.tv_sec = 4, .tv_usec = 500'000};
    std::signal(SIGALRM, SIG_DFL);
    setitimer(ITIMER_REAL, &timer, nullptr);
}

/// Ends the process if the guard is not gone in time.
void endSurely(Clock::time_point asked) {
    if (endsBy(asked + LateAfter)) return;
    // On a thread of its own: it may hang as well.
    std::thread([] {
        const std::lock_guard lock(late().mutex);
        for (const auto& [whose, what] : late().all) what();
    }).detach();
    if (endsBy(asked + EndAfter)) return;
    std::fputs("does not end by itself: a library hangs; what was recorded is closed\n", stderr);
    std::_Exit(EXIT_FAILURE);
}

/// Opens the pipe, or drops what a handler wrote too late for the previous guard.
bool openPipe() {
    if (wakeUp[0] < 0) return pipe2(wakeUp.data(), O_CLOEXEC) == 0;
    int waiting = 0;
    while (ioctl(wakeUp[0], FIONREAD, &waiting) == 0 && waiting > 0) takeByte();
    return true;
}

}  // namespace

WhenLate::WhenLate(std::function<void()> what) {
    const std::lock_guard lock(late().mutex);
    late().all.emplace(this, std::move(what));
}

WhenLate::~WhenLate() {
    const std::lock_guard lock(late().mutex);
    late().all.erase(this);
}

InterruptGuard::InterruptGuard(End end) {
    if (!openPipe()) return;  // Ctrl-C then ends the process at once
    firstAt = 0;
    // A copy: the guard is not destroyed where a library ends the process by exit().
    m_waiter = std::thread([source = m_source, end]() mutable {
        if (takeByte() != Came) return;
        const auto asked = Clock::now();
        if (end == End::Surely) endAtTheLatest();
        source.request_stop();
        if (end == End::Surely) endSurely(asked);
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
    putByte(GuardGone);
    m_waiter.join();
}

}  // namespace leitstand
