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

/// How far the session's work is.
struct SessionProgress {
    enum class Step : std::uint8_t { Reading, Registering };
    Step step = Step::Reading;
    std::string name;       ///< of the file or scan at work
    int scan = 0;           ///< its number, from 1
    int scans = 0;          ///< how many the job has; 0: not known yet
    double fraction = 0.0;  ///< of the whole job, 0 to 1
};

/// Something the operator should know: an error cost a scan, a warning did not.
struct SessionMessage {
    enum class Severity : std::uint8_t { Warning, Error };
    Severity severity = Severity::Error;
    std::string text;  ///< names file, place and expectation
};

/// How a job ended.
struct SessionOutcome {
    bool cancelled = false;
    int added = 0;         ///< scans that the job registered
    double seconds = 0.0;  ///< wall clock [s]
};

/// Who is told what the session does. All are called on the session's thread and may call its functions; any
/// may be empty.
struct SessionListener {
    std::function<void(MapPtr)> onMap;                       ///< a new snapshot, never null
    std::function<void(const SessionProgress&)> onProgress;  ///< may come many times a second
    std::function<void(const SessionMessage&)> onMessage;
    std::function<void(const SessionOutcome&)> onFinished;  ///< once for each job, after all else of it
};

/// Endings of files that hold a scan, with their dots, in small letters.
[[nodiscard]] std::vector<std::string> scanEndings();

/// Reads scans and registers them into one map on a thread of its own. Its functions give it jobs, return at
/// once and may be called on any thread; jobs are done in order.
class ScanSession {
public:
    explicit ScanSession(SessionListener listener);
    /// Cancels everything and waits for the thread: at most as long as a step of the registration takes.
    ~ScanSession();
    ScanSession(const ScanSession&) = delete;
    ScanSession& operator=(const ScanSession&) = delete;

    /// Reads the files, folders and missions @p sources and registers their scans one by one onto the map; a
    /// file that cannot be read is a message, the others still load; one that is in the map already is left
    /// out. A map that has scans goes on with its own settings, an empty one takes @p settings. Cancelled:
    /// what was registered stays.
    void open(std::vector<std::filesystem::path> sources, RegistrationSettings settings);
    /// Registers the map's scans anew; each keeps its old pose until it has its new one. Cancelled: the old
    /// map comes back.
    void registerAgain(RegistrationSettings settings);
    /// Cancels all jobs and empties the map.
    void clear();
    /// Cancels the job at work and all that wait, clear() excepted.
    void cancel();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
