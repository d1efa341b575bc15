#include "tests/app/latency/gui_watch.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace leitstand::test {
namespace {

constexpr double Tick = 5.0;  ///< [ms]

/// How long this thread has waited for a processor [ns]; nothing when the system does not tell.
std::optional<std::int64_t> waitedForProcessor() {
    std::ifstream file("/proc/thread-self/schedstat");
    std::int64_t ran = 0, waited = 0;
    if (!(file >> ran >> waited)) return std::nullopt;
    return waited;
}

}  // namespace

GuiWatch::GuiWatch() : m_last(std::chrono::steady_clock::now()), m_waited(waitedForProcessor()) {
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &GuiWatch::look);
    m_timer.start(static_cast<int>(Tick));
}

void GuiWatch::clear() {
    m_wall.clear();
    m_own.clear();
    m_last = std::chrono::steady_clock::now();
    m_waited = waitedForProcessor();
}

void GuiWatch::look() {
    const auto now = std::chrono::steady_clock::now();
    const auto waited = waitedForProcessor();
    const double away = std::max(0.0, std::chrono::duration<double, std::milli>(now - m_last).count() - Tick);
    const double others = waited && m_waited ? static_cast<double>(*waited - *m_waited) / 1e6 : 0.0;
    m_wall.push_back(away);
    m_own.push_back(std::max(0.0, away - others));
    m_last = now;
    m_waited = waited;
}

GuiWatch::Figures GuiWatch::figures(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
    };
    return {values.size(), at(0.5), at(0.99), values.back()};
}

}  // namespace leitstand::test
