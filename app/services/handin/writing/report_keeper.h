#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

#include "app/services/handin/writing/report_writer.h"
#include "core/base/result.h"

namespace leitstand {

/// Keeps the hand-in of a mission that is being recorded up to date: writes it again at an interval, counted
/// from begin to begin, and whenever it is asked, on a thread of its own that gives way to all others. It
/// must end before the mission is closed, whose log it reads.
class ReportKeeper {
public:
    struct Settings {
        std::filesystem::path mission, out;
        ReportOptions options;
        std::chrono::nanoseconds interval = std::chrono::seconds(60);
    };
    /// @p onWritten is called on the keeper's thread after each attempt.
    ReportKeeper(Settings settings, std::function<void(const Result<ReportOutcome>&)> onWritten);
    ~ReportKeeper();  ///< a report that is being written is given up; files are whole all the same
    ReportKeeper(const ReportKeeper&) = delete;
    ReportKeeper& operator=(const ReportKeeper&) = delete;

    /// Writes now, or once more when it is just writing. Any thread.
    void writeNow();
    void end();  ///< nothing is begun any more; does not wait for what is being written

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
