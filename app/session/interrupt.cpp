#include "app/session/interrupt.h"

#include <array>
#include <cassert>
#include <csignal>
#include <memory>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

namespace leitstand {
namespace {

struct Taken {
    int signal;
    struct sigaction before = {};
};

// request_stop is not allowed in a signal handler, so the handler writes to a pipe and a thread stops the
// work.
std::array<Taken, 3> signals = {{{.signal = SIGINT}, {.signal = SIGTERM}, {.signal = SIGHUP}}};
std::array<int, 2> wakeUp = {-1, -1};
std::unique_ptr<std::stop_source> source;
std::jthread waiter;

void giveBack() {
    for (const Taken& one : signals) sigaction(one.signal, &one.before, nullptr);
}

void onSignal(int /*signal*/) {
    giveBack();
    const char byte = 1;
    [[maybe_unused]] const auto written = write(wakeUp[1], &byte, 1);
}

}  // namespace

InterruptGuard::InterruptGuard() {
    assert(!source);
    source = std::make_unique<std::stop_source>();
    if (pipe2(wakeUp.data(), O_CLOEXEC) != 0) return;  // Ctrl-C then ends the process at once
    waiter = std::jthread([] {
        char byte = 0;
        if (read(wakeUp[0], &byte, 1) == 1 && byte == 1) source->request_stop();
    });
    struct sigaction handler = {};
    handler.sa_handler = onSignal;
    handler.sa_flags = SA_RESTART;
    for (Taken& one : signals) sigaction(one.signal, nullptr, &one.before);
    for (const Taken& one : signals) {
        if (one.before.sa_handler != SIG_IGN) sigaction(one.signal, &handler, nullptr);
    }
}

InterruptGuard::~InterruptGuard() {
    if (waiter.joinable()) {
        giveBack();
        const char byte = 0;
        [[maybe_unused]] const auto written = write(wakeUp[1], &byte, 1);
        waiter.join();
        close(wakeUp[0]);
        close(wakeUp[1]);
    }
    source.reset();
}

std::stop_token InterruptGuard::token() const {
    return source->get_token();
}

}  // namespace leitstand
