#include "app/services/offline/scan_session.h"

#include <chrono>
#include <exception>
#include <set>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "app/services/job_queue.h"
#include "app/services/offline/mission_scans.h"
#include "core/base/time.h"
#include "core/io/clouds/cloud_formats.h"
#include "core/io/clouds/scan_source.h"
#include "core/mapping/offline_mapper.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Severity = SessionMessage::Severity;
using Step = SessionProgress::Step;

/// A scan to be registered.
struct PendingScan {
    fs::path key;   ///< its file or its mission, which shows whether it is in the map already
    ScanPtr known;  ///< of a mission; null: to be read from the file
};

/// Share of a scan's work that reading its file takes, roughly.
constexpr double ReadingShare = 0.2;

}  // namespace

/// State of the session's thread; other threads touch only the queue.
struct ScanSession::State {
    SessionListener listener;
    std::unique_ptr<OfflineMapper> mapper;  ///< null while the map is empty
    MapPtr map = std::make_shared<const Map>();
    std::set<fs::path> files;  ///< whose scans are in the map
    JobQueue queue;
    std::jthread thread;  ///< last: joined first

    void submit(std::function<SessionOutcome(const std::stop_token&)> job, bool cancellable = true);
    SessionOutcome open(const std::vector<fs::path>& sources, const RegistrationSettings& settings,
                        const std::stop_token& cancelled);
    SessionOutcome registerAgain(const RegistrationSettings& settings, const std::stop_token& cancelled);
    SessionOutcome clear();

    std::vector<PendingScan> newScans(const std::vector<fs::path>& sources, const std::stop_token& cancelled);
    void addMission(const fs::path& mission, std::vector<PendingScan>& pending,
                    const std::stop_token& cancelled);
    void addFiles(const fs::path& source, std::vector<PendingScan>& pending, std::set<fs::path>& known);
    ScanPtr read(const PendingScan& pending);
    Progress progressOf(const std::string& name, int scan, int scans, const std::stop_token& cancelled);

    void publish(MapPtr newMap) {
        map = std::move(newMap);
        if (listener.onMap) listener.onMap(map);
    }
    void notify(Severity severity, std::string text) const {
        if (listener.onMessage) listener.onMessage({severity, std::move(text)});
    }
    void notify(const SessionProgress& progress) const {
        if (listener.onProgress) listener.onProgress(progress);
    }
};

void ScanSession::State::submit(std::function<SessionOutcome(const std::stop_token&)> job, bool cancellable) {
    queue.submit(
        [this, job = std::move(job)](const std::stop_token& cancelled) {
            const auto start = Clock::now();
            SessionOutcome outcome;
            try {
                outcome = job(cancelled);
            } catch (const std::exception& broken) {
                notify(Severity::Error, broken.what());
                publish(mapper ? mapper->map() : std::make_shared<const Map>());
            }
            outcome.seconds = toSeconds(Clock::now() - start);
            if (listener.onFinished) listener.onFinished(outcome);
        },
        cancellable);
}

/// Returns the scans in @p sources that are not in the map; reports those that are or cannot be found.
std::vector<PendingScan> ScanSession::State::newScans(const std::vector<fs::path>& sources,
                                                      const std::stop_token& cancelled) {
    std::vector<PendingScan> pending;
    std::set<fs::path> known = files;
    for (const fs::path& source : sources) {
        if (!isMission(source)) {
            addFiles(source, pending, known);
        } else if (known.insert(fs::weakly_canonical(source)).second) {
            addMission(source, pending, cancelled);
        } else {
            notify(Severity::Warning, fmt::format("{}: in the map already, left out", source.string()));
        }
    }
    return pending;
}

void ScanSession::State::addFiles(const fs::path& source, std::vector<PendingScan>& pending,
                                  std::set<fs::path>& known) {
    const auto found = listScans({source});
    if (!found) return notify(Severity::Error, found.error().text);
    int repeated = 0;
    for (const fs::path& file : found.value()) {
        if (known.insert(fs::weakly_canonical(file)).second) {
            pending.push_back({file, nullptr});
        } else {
            ++repeated;
        }
    }
    if (repeated > 0) {
        notify(Severity::Warning,
               fmt::format("{}: {} in the map already, left out", source.string(),
                           repeated == 1 ? "one scan is" : fmt::format("{} scans are", repeated)));
    }
}

void ScanSession::State::addMission(const fs::path& mission, std::vector<PendingScan>& pending,
                                    const std::stop_token& cancelled) {
    const std::string name = mission.filename().string();
    const auto report = [&](double fraction) {
        notify({Step::Reading, name, 0, 0, ReadingShare * fraction});
    };
    auto read = readMissionScans(mission, {report, cancelled});
    if (!read) return notify(Severity::Error, read.error().text);
    for (const std::string& warning : read->warnings) notify(Severity::Warning, warning);
    for (const ScanPtr& scan : read->scans) pending.push_back({fs::weakly_canonical(mission), scan});
}

/// Returns the scan of @p pending; null when it cannot be read, after reporting why.
ScanPtr ScanSession::State::read(const PendingScan& pending) {
    if (pending.known) return pending.known;
    auto reading = readScan(pending.key);
    if (!reading) {
        notify(Severity::Error, reading.error().text);
        return nullptr;
    }
    for (const std::string& warning : reading->warnings) notify(Severity::Warning, warning);
    return std::make_shared<const Scan>(std::move(reading).value().scan);
}

Progress ScanSession::State::progressOf(const std::string& name, int scan, int scans,
                                        const std::stop_token& cancelled) {
    const auto report = [this, name, scan, scans](double fraction) {
        const double ofScan = ReadingShare + (1.0 - ReadingShare) * fraction;
        notify({Step::Registering, name, scan, scans, (scan - 1 + ofScan) / scans});
    };
    return {report, cancelled};
}

SessionOutcome ScanSession::State::open(const std::vector<fs::path>& sources,
                                        const RegistrationSettings& settings,
                                        const std::stop_token& cancelled) {
    SessionOutcome outcome;
    const std::vector<PendingScan> fresh = newScans(sources, cancelled);
    const int scans = static_cast<int>(fresh.size());
    for (int i = 0; i < scans && !cancelled.stop_requested(); ++i) {
        const PendingScan& pending = fresh[static_cast<std::size_t>(i)];
        if (!pending.known) {
            notify({Step::Reading, pending.key.filename().string(), i + 1, scans, double(i) / scans});
        }
        const ScanPtr scan = read(pending);
        if (!scan) continue;
        if (!mapper) mapper = std::make_unique<OfflineMapper>(settings);
        const Progress progress = progressOf(scan->name, i + 1, scans, cancelled);
        progress.done(0.0);
        if (!mapper->add(scan, progress)) break;
        files.insert(fs::weakly_canonical(pending.key));
        ++outcome.added;
        publish(mapper->map());
    }
    outcome.cancelled = cancelled.stop_requested();
    return outcome;
}

SessionOutcome ScanSession::State::registerAgain(const RegistrationSettings& settings,
                                                 const std::stop_token& cancelled) {
    SessionOutcome outcome;
    const MapPtr old = map;
    const int scans = static_cast<int>(old->scans.size());
    auto fresh = std::make_unique<OfflineMapper>(settings);
    for (int i = 0; i < scans; ++i) {
        const ScanPtr& scan = old->scans[static_cast<std::size_t>(i)].scan;
        const Progress progress = progressOf(scan->name, i + 1, scans, cancelled);
        progress.done(0.0);
        if (cancelled.stop_requested() || !fresh->add(scan, progress)) {
            publish(old);
            outcome.cancelled = true;
            return outcome;
        }
        ++outcome.added;
        auto mixed = std::make_shared<Map>(*fresh->map());
        mixed->scans.insert(mixed->scans.end(), old->scans.begin() + i + 1, old->scans.end());
        publish(std::move(mixed));
    }
    if (scans > 0) mapper = std::move(fresh);
    return outcome;
}

SessionOutcome ScanSession::State::clear() {
    mapper.reset();
    files.clear();
    publish(std::make_shared<const Map>());
    return {};
}

std::vector<std::string> scanEndings() {
    std::vector<std::string> endings;
    for (const CloudFormat& format : cloudFormats()) endings.emplace_back(format.ending);
    return endings;
}

ScanSession::ScanSession(SessionListener listener) : m_state(std::make_unique<State>()) {
    m_state->listener = std::move(listener);
    m_state->thread =
        std::jthread([state = m_state.get()](const std::stop_token& stop) { state->queue.work(stop); });
}

ScanSession::~ScanSession() {
    m_state->thread.request_stop();
    m_state->queue.cancel();
}

void ScanSession::open(std::vector<fs::path> sources, RegistrationSettings settings) {
    m_state->submit([state = m_state.get(), sources = std::move(sources),
                     settings = std::move(settings)](const std::stop_token& cancelled) {
        return state->open(sources, settings, cancelled);
    });
}

void ScanSession::registerAgain(RegistrationSettings settings) {
    m_state->submit(
        [state = m_state.get(), settings = std::move(settings)](const std::stop_token& cancelled) {
            return state->registerAgain(settings, cancelled);
        });
}

void ScanSession::clear() {
    m_state->queue.cancel();
    m_state->submit([state = m_state.get()](const std::stop_token&) { return state->clear(); }, false);
}

void ScanSession::cancel() {
    m_state->queue.cancel();
}

}  // namespace leitstand
