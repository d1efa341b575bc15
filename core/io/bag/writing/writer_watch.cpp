// The watching half of WriterCore: statistics and alarms.
#include "core/base/time.h"
#include "core/io/bag/writing/writer_core.h"

namespace leitstand::detail {

namespace {

constexpr auto WatchInterval = std::chrono::milliseconds(250);

}  // namespace

BagWriterStatistics WriterCore::statistics() const {
    const std::scoped_lock lock(m_mutex);
    BagWriterStatistics statistics;
    statistics.bytesPerSecond = m_rate;
    statistics.queuedEvents = m_queue.events();
    statistics.queuedBytes = m_queue.bytes();
    statistics.writtenEvents = m_writtenEvents;
    statistics.writtenBytes = m_writtenBytes;
    statistics.dropped = m_queue.dropped();
    statistics.commits = m_commits;
    statistics.lastCommit = m_lastCommit;
    statistics.minutesLeft = m_minutesLeft;
    statistics.problem = m_failure;
    return statistics;
}

DiskReading WriterCore::reading() {
    DiskReading reading;
    reading.freeBytes = m_store->freeBytes();  // may block
    reading.where = m_store->file().string();
    const std::scoped_lock lock(m_mutex);
    reading.now = Clock::now();
    reading.writtenBytes = m_writtenBytes;
    reading.droppedPictures = m_queue.droppedPictures();
    reading.lostEvents = m_queue.lostEvents();
    reading.queuedBytes = m_queue.bytes();
    reading.full = m_diskFull;
    if (!m_diskFull) reading.failure = m_failure;
    if (m_committing) {
        reading.secondsBehind = toSeconds(reading.now - m_oldestTaken);
    }
    return reading;
}

void WriterCore::watch() {
    DiskWatch disk(m_settings.alarmMinutes);
    for (bool last = false; !last;) {
        const std::vector<BagAlarm> changed = disk.update(reading());
        if (m_onAlarm) {
            for (const BagAlarm& alarm : changed) m_onAlarm(alarm);
        }
        std::unique_lock lock(m_mutex);
        m_rate = disk.bytesPerSecond();
        m_minutesLeft = disk.minutesLeft();
        last = m_watchStopping;
        if (!last) m_watchWake.wait_for(lock, WatchInterval);
    }
}

}  // namespace leitstand::detail
