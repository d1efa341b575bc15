#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

#include "app/services/offline/scan_session.h"

namespace leitstand::test {

/// Writes down what a session tells, and lets a test wait for it.
class SessionRecorder {
public:
    struct Record {
        std::vector<MapPtr> maps;
        std::vector<SessionProgress> progress;
        std::vector<SessionMessage> messages;
        std::vector<SessionOutcome> outcomes;
    };

    /// Called on the session's thread after each map or progress was written down; set before the session
    /// begins.
    std::function<void(const Record&)> onEvent;

    [[nodiscard]] SessionListener listener() {
        return {
            [this](MapPtr map) { write([&](Record& record) { record.maps.push_back(std::move(map)); }); },
            [this](const SessionProgress& progress) {
                write([&](Record& record) { record.progress.push_back(progress); });
            },
            [this](const SessionMessage& message) {
                write([&](Record& record) { record.messages.push_back(message); });
            },
            [this](const SessionOutcome& outcome) {
                write([&](Record& record) { record.outcomes.push_back(outcome); });
            },
        };
    }

    /// Waits until @p count jobs have ended; false after two minutes.
    [[nodiscard]] bool waitForOutcomes(std::size_t count) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, std::chrono::minutes(2),
                                  [&] { return m_record.outcomes.size() >= count; });
    }
    [[nodiscard]] Record record() const {
        const std::scoped_lock lock(m_mutex);
        return m_record;
    }

private:
    template <class Write>
    void write(Write write) {
        Record now;
        {
            const std::scoped_lock lock(m_mutex);
            write(m_record);
            if (onEvent) now = m_record;
        }
        m_changed.notify_all();
        if (onEvent) onEvent(now);
    }

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    Record m_record;
};

}  // namespace leitstand::test
