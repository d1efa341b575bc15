#include "app/cli/console/progress_line.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "core/base/printable.h"

namespace leitstand::cli {

ProgressLine::ProgressLine() : m_terminal(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    clear();
}

void ProgressLine::show(const std::string& what, double fraction) {
    show(fmt::format("{} {:3.0f} %", what, 100.0 * std::clamp(fraction, 0.0, 1.0)));
}

void ProgressLine::show(const std::string& what) {
    if (!m_terminal) return;
    using namespace std::chrono;
    const auto now = duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
    if (m_shown && now - m_lastMilliseconds < 100) return;
    m_lastMilliseconds = now;
    m_shown = true;
    fmt::print(stderr, "\r\x1b[K{}", printable(what));
    std::fflush(stderr);
}

void ProgressLine::clear() {
    if (!m_shown) return;
    m_shown = false;
    fmt::print(stderr, "\r\x1b[K");
    std::fflush(stderr);
}

}  // namespace leitstand::cli
