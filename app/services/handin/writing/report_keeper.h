#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

#include "app/services/handin/writing/report_writer.h"
#include "core/base/result.h"

namespace leitstand {

/// Keeps the hand-in of a mission up to date while it is recorded. Writes it on request, and at an interval
/// (from start to start). Works on its own thread with the lowest priority. It must end before the mission is
/// closed, because it reads the mission's log.
class ReportKeeper {
public:
    struct Settings {
        std::filesystem::path mission, out;
        ReportOptions options;
        std::chrono::nanoseconds interval = std::chrono::seconds(60);
    };
    /// @p onWritten: called on the keeper's thread after each attempt.
    ReportKeeper(Settings settings, std::function<void(const Result<ReportOutcome>&)> onWritten);
    ~ReportKeeper();  ///< cancels a report that is being written; its files are complete all the same
    ReportKeeper(const ReportKeeper&) = delete;
    ReportKeeper& operator=(const ReportKeeper&) = delete;

    /// Writes now; if it is already writing, writes once more after that. Any thread.
    void writeNow();
    void end();  ///< begins no further reports; does not wait for one that is being written

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
