#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "core/io/bag/bag_writer.h"

namespace leitstand::detail {

/// State of a writer's disk at one moment.
struct DiskReading {
    std::chrono::steady_clock::time_point now{};
    std::uint64_t writtenBytes = 0, freeBytes = 0;
    std::uint64_t droppedPictures = 0, lostEvents = 0;
    std::size_t queuedBytes = 0;
    double secondsBehind = 0.0;  ///< age of the oldest event that is not on the disk [s]
    bool full = false;           ///< the last attempt met a full disk
    std::string failure;         ///< other reason why the last attempt failed; empty: there is none
    std::string where;           ///< the file that is written
};

/// Computes how fast the disk fills, how many minutes are left, and when alarms begin and end. Not
/// thread-safe.
class DiskWatch {
public:
    explicit DiskWatch(double alarmMinutes) : m_alarmMinutes(alarmMinutes) {}
    /// Returns the alarms that changed since the last reading.
    [[nodiscard]] std::vector<BagAlarm> update(const DiskReading& reading);
    [[nodiscard]] double bytesPerSecond() const { return m_rate; }
    [[nodiscard]] double minutesLeft() const { return m_minutesLeft; }

private:
    struct Mark {
        std::chrono::steady_clock::time_point time{};
        std::uint64_t bytes = 0;
    };
    void measure(const DiskReading& reading);
    /// Adds an alarm to @p changed if it begins or ends. @p raised: whether its condition is true. @p text:
    /// used when it begins. @p over: used when it ends.
    void judge(BagAlarm::Kind kind, bool raised, const std::string& text, const std::string& over,
               std::vector<BagAlarm>& changed);

    double m_alarmMinutes;
    double m_rate = 0.0, m_minutesLeft = std::numeric_limits<double>::infinity();
    std::deque<Mark> m_marks;  // of the last seconds
    std::map<BagAlarm::Kind, bool> m_raised;
    std::uint64_t m_droppedPictures = 0, m_lostEvents = 0;
    std::chrono::steady_clock::time_point m_lastDrop{}, m_lastLoss{};
};

}  // namespace leitstand::detail
