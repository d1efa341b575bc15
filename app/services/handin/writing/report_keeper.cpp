#include "app/services/handin/writing/report_keeper.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/words.h"

namespace leitstand {
namespace {

constexpr int LeastRest = 4;  // least rest after a report, as a part of the interval: interval / LeastRest

/// Robots are driven at the same time: the calling thread computes when others need no processor. On Linux
/// this is set per thread, and threads that it starts inherit it.
void giveWay() {
    constexpr int Nice = 5;  // a third of another's share, so that it is written on a busy machine too
    beginSharedThreads();
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), Nice);
}

}  // namespace

struct ReportKeeper::State {
    Settings settings;
    std::function<void(const Result<ReportOutcome>&)> onWritten;
    std::mutex mutex;
    std::condition_variable_any wake;
    bool asked = false;
    std::jthread thread;  // last member: joined first

    /// Whatever goes wrong with a report, the station goes on.
    [[nodiscard]] Result<ReportOutcome> written(const std::stop_token& stop) const {
        try {
            return writeReport(settings.mission, settings.out, settings.options, {{}, stop});
        } catch (const std::exception& problem) {
            return Error{leitstand::fill(translate("leitstand::Error", "{}: no report: {}"),
                                         settings.out.string(), problem.what())};
        }
    }

    void run(const std::stop_token& stop) {
        giveWay();
        auto begun = std::chrono::steady_clock::now();
        while (!stop.stop_requested()) {
            {
                const auto rest = std::chrono::steady_clock::now() + settings.interval / LeastRest;
                std::unique_lock lock(mutex);
                wake.wait_until(lock, stop, std::max(begun + settings.interval, rest),
                                [this] { return asked; });
                asked = false;
            }
            if (stop.stop_requested()) return;
            begun = std::chrono::steady_clock::now();
            const auto outcome = written(stop);
            if (!stop.stop_requested() && onWritten) onWritten(outcome);
        }
    }
};

ReportKeeper::ReportKeeper(Settings settings, std::function<void(const Result<ReportOutcome>&)> onWritten)
    : m_state(std::make_unique<State>()) {
    m_state->settings = std::move(settings);
    m_state->onWritten = std::move(onWritten);
    m_state->thread =
        std::jthread([state = m_state.get()](const std::stop_token& stop) { state->run(stop); });
}

ReportKeeper::~ReportKeeper() = default;

void ReportKeeper::end() {
    m_state->thread.request_stop();
}

void ReportKeeper::writeNow() {
    {
        const std::lock_guard lock(m_state->mutex);
        m_state->asked = true;
    }
    m_state->wake.notify_all();
}

}  // namespace leitstand
