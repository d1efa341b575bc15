#include "app/window/orderly_end.h"

#include <array>
#include <csignal>

#include <QApplication>
#include <QSocketNotifier>

#include <fcntl.h>
#include <unistd.h>

namespace leitstand {
namespace {

constexpr std::array Signals = {SIGINT, SIGTERM, SIGHUP};

// A signal handler may do next to nothing: it writes into a pipe of which the event loop reads.
std::array<int, 2> wakeUp = {-1, -1};

void onSignal(int /*signal*/) {
    for (const int one : Signals) std::signal(one, SIG_DFL);
    const char byte = 1;
    [[maybe_unused]] const auto written = ::write(wakeUp[1], &byte, 1);
}

void closeAll() {
    QApplication::closeAllWindows();
    QApplication::exit();
}

}  // namespace

OrderlyEnd::OrderlyEnd(QObject* parent) : QObject(parent) {
    if (::pipe2(wakeUp.data(), O_CLOEXEC) != 0) return;  // a signal then ends the process at once
    auto* const came = new QSocketNotifier(wakeUp[0], QSocketNotifier::Read, this);
    connect(came, &QSocketNotifier::activated, this, [came] {
        came->setEnabled(false);
        closeAll();
    });
    for (const int one : Signals) {
        if (std::signal(one, onSignal) == SIG_IGN) std::signal(one, SIG_IGN);  // as nohup wants it
    }
}

OrderlyEnd::~OrderlyEnd() {
    if (wakeUp[0] < 0) return;
    for (const int one : Signals) std::signal(one, SIG_DFL);
    for (int& end : wakeUp) {
        ::close(end);
        end = -1;
    }
}

}  // namespace leitstand
