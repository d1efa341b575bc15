#include "app/cli/interrupt.h"

#include <array>
#include <cassert>
#include <csignal>
#include <memory>
#include <thread>

#include <unistd.h>

namespace leitstand::cli {
namespace {

// request_stop is not allowed in a signal handler, so the handler writes to a pipe and a thread stops the
// work.
std::array<int, 2> wakeUp = {-1, -1};
std::unique_ptr<std::stop_source> source;
std::jthread waiter;

void onSignal(int signal) {
    std::signal(signal, SIG_DFL);
    const char byte = 1;
    [[maybe_unused]] const auto written = write(wakeUp[1], &byte, 1);
}

}  // namespace

InterruptGuard::InterruptGuard() {
    assert(!source);
    source = std::make_unique<std::stop_source>();
    if (pipe(wakeUp.data()) != 0) return;  // Ctrl-C then ends the process at once
    waiter = std::jthread([] {
        char byte = 0;
        if (read(wakeUp[0], &byte, 1) == 1 && byte == 1) source->request_stop();
    });
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    if (waiter.joinable()) {
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

}  // namespace leitstand::cli
