#include "app/services/station/safety/station_guards.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "core/base/words.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

constexpr auto TriedAgain = 2s;       ///< after a guard could not be started, or has ended
constexpr auto LooksAtLeast = 500ms;  ///< for guards that have to be tried again

SteadyTime moment() {
    return std::chrono::steady_clock::now();
}

}  // namespace

StationGuards::StationGuards(Setup setup)
    : m_setup(std::move(setup)), m_wake(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    for (const auto& [robot, words] : m_setup.words) m_entries.try_emplace(robot);
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

StationGuards::~StationGuards() {
    m_thread.request_stop();
    wake();
    m_thread.join();
    close(m_wake);
}

void StationGuards::wake() const {
    static_cast<void>(eventfd_write(m_wake, 1));
}

void StationGuards::want(const std::string& robot, bool wanted) {
    const auto found = m_entries.find(robot);
    if (found == m_entries.end() || found->second.wanted.exchange(wanted) == wanted) return;
    wake();
}

bool StationGuards::allows(const std::string& robot) const {
    const auto found = m_entries.find(robot);
    return found == m_entries.end() || !found->second.wanted || found->second.ready;
}

void StationGuards::pulse(const std::string& robot, const GuardPulse& pulse) {
    const auto found = m_entries.find(robot);
    if (found == m_entries.end() || !found->second.ready) return;
    Entry& entry = found->second;
    const std::lock_guard lock(entry.mutex);
    if (entry.process && !entry.process->pulse(pulse)) {
        entry.deaf = true;  // it hangs, or is gone
        entry.ready = false;
        wake();
    }
}

GuardView StationGuards::view(const std::string& robot) const {
    using State = GuardView::State;
    const auto found = m_entries.find(robot);
    if (found == m_entries.end() || !found->second.wanted) return {};
    if (found->second.ready) return {State::Ready};
    const std::lock_guard lock(found->second.mutex);
    if (found->second.problem.empty()) return {State::Starting};
    return {State::Failed, found->second.problem};
}

std::optional<pid_t> StationGuards::processOf(const std::string& robot) const {
    const auto found = m_entries.find(robot);
    if (found == m_entries.end()) return std::nullopt;
    const std::lock_guard lock(found->second.mutex);
    return found->second.process ? std::optional(found->second.process->id()) : std::nullopt;
}

void StationGuards::begin(const std::string& robot, Entry& entry) {
    auto started = GuardProcess::start(m_setup.program, m_setup.words.at(robot));
    const std::lock_guard lock(entry.mutex);
    if (started) {
        entry.process = std::move(started).value();
    } else {
        entry.problem = started.error().text;
        entry.failed = moment();
    }
}

/// Brings a robot's guard into the wanted state; true when that allows or forbids driving from now on.
bool StationGuards::look(const std::string& robot, Entry& entry, bool stopping) {
    const bool wanted = entry.wanted && !stopping, before = entry.ready;
    std::unique_ptr<GuardProcess> over;  // ends without the lock, so that nobody waits for it
    {
        const std::lock_guard lock(entry.mutex);
        const bool alive = entry.process && entry.process->read() && !entry.deaf;
        if (entry.process && !alive) {
            entry.process->kill();
            entry.problem = translate("leitstand::Error", "leitstand-guard has ended");
            entry.failed = moment();
        }
        entry.deaf = false;
        if (alive && entry.process->isReady(moment())) entry.problem.clear();
        if (!alive || !wanted) over = std::move(entry.process);
        if (!wanted) entry.problem.clear();
        entry.ready = entry.process && entry.process->isReady(moment());
    }
    if (over) over->pulse({});
    over.reset();
    const bool tryNow = entry.problem.empty() || moment() - entry.failed >= TriedAgain;
    if (wanted && !entry.process && tryNow) begin(robot, entry);
    notifyTrouble(robot, entry);
    return entry.ready != before;
}

void StationGuards::notifyTrouble(const std::string& robot, Entry& entry) {
    {
        const std::lock_guard lock(entry.mutex);
        if (entry.problem == entry.notified) return;
        entry.notified = entry.problem;
    }
    if (!entry.notified.empty()) m_setup.onTrouble(robot, entry.notified);
}

void StationGuards::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::vector<pollfd> polled = {{m_wake, POLLIN, 0}};
        for (auto& [robot, entry] : m_entries) {
            if (look(robot, entry, false)) m_setup.onChange(robot);
            if (entry.process) polled.push_back({entry.process->pipe(), POLLIN, 0});
        }
        poll(polled.data(), polled.size(), static_cast<int>(std::chrono::milliseconds(LooksAtLeast).count()));
        eventfd_t ignored = 0;
        static_cast<void>(eventfd_read(m_wake, &ignored));
    }
    for (auto& [robot, entry] : m_entries) static_cast<void>(look(robot, entry, true));
}

}  // namespace leitstand
