#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/mapping/map.h"
#include "core/mapping/registration_settings.h"

namespace leitstand {

/// Progress of the session's work.
struct SessionProgress {
    enum class Step : std::uint8_t { Reading, Registering };
    Step step = Step::Reading;
    std::string name;       ///< name of the present file or scan
    int scan = 0;           ///< its number, from 1
    int scans = 0;          ///< number of scans in the job; 0: not known yet
    double fraction = 0.0;  ///< finished share of the whole job, 0 to 1
};

/// A message for the operator. An error means that a scan is missing; a warning does not.
struct SessionMessage {
    enum class Severity : std::uint8_t { Warning, Error };
    Severity severity = Severity::Error;
    std::string text;  ///< names file, place and what was expected
};

/// The result of a job.
struct SessionOutcome {
    bool cancelled = false;
    int added = 0;         ///< number of scans that the job registered
    double seconds = 0.0;  ///< wall clock [s]
};

/// Receives what the session does. All functions are called on the session's thread and may call functions of
/// the session. Each may be empty.
struct SessionListener {
    std::function<void(MapPtr)> onMap;                       ///< a new snapshot, never null
    std::function<void(const SessionProgress&)> onProgress;  ///< may be called many times a second
    std::function<void(const SessionMessage&)> onMessage;
    /// Called once for each job, after its other calls.
    std::function<void(const SessionOutcome&)> onFinished;
};

/// Returns the endings of files that hold a scan, with their dots, in lower case.
[[nodiscard]] std::vector<std::string> scanEndings();

/// Reads scans and registers them into one map, on its own thread. Its functions add jobs and return at once.
/// They may be called on any thread; jobs run in order.
class ScanSession {
public:
    explicit ScanSession(SessionListener listener);
    /// Cancels everything and waits for the thread: for at most one step of the registration.
    ~ScanSession();
    ScanSession(const ScanSession&) = delete;
    ScanSession& operator=(const ScanSession&) = delete;

    /// Reads the files, folders and missions in @p sources and registers their scans one by one into the map.
    /// A file that cannot be read causes a message; the others are still loaded. A source that is already in
    /// the map is left out. If the map has scans, it keeps its own settings; if it is empty, it takes
    /// @p settings. When cancelled, scans that were registered remain.
    void open(std::vector<std::filesystem::path> sources, RegistrationSettings settings);
    /// Registers the map's scans again. Each keeps its old pose until it has its new one. When cancelled, the
    /// old map is restored.
    void registerAgain(RegistrationSettings settings);
    /// Cancels all jobs and empties the map.
    void clear();
    /// Cancels the running job and all waiting jobs, except clear().
    void cancel();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
