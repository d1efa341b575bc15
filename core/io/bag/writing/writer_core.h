#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/bag_writer.h"
#include "core/io/bag/writing/bag_store.h"
#include "core/io/bag/writing/disk_watch.h"
#include "core/io/bag/writing/event_queue.h"

namespace leitstand::detail {

/// The two threads of a BagWriter. One waits for the disk. The other watches it, so that a disk that hangs
/// cannot delay its alarm.
class WriterCore {
public:
    WriterCore(std::unique_ptr<BagStore> store, const BagWriterSettings& settings,
               BagWriter::AlarmHandler onAlarm);
    ~WriterCore();

    void addTopic(const TopicInfo& topic);
    void write(RawEvent event);
    [[nodiscard]] BagWriterStatistics statistics() const;
    [[nodiscard]] Result<void> flush(std::chrono::milliseconds deadline);
    [[nodiscard]] Result<void> close();
    [[nodiscard]] const BagStore& store() const { return *m_store; }

private:
    using Clock = std::chrono::steady_clock;
    using TopicKey = std::pair<std::string, std::string>;  // name, type
    struct TopicUse {
        bool droppable = false, urgent = false;
    };

    void announce(const TopicInfo& topic);  // locked
    void run();
    [[nodiscard]] bool shallCommit(Clock::time_point now) const;              // locked
    [[nodiscard]] Clock::time_point nextCommit(Clock::time_point now) const;  // locked; for what waits
    [[nodiscard]] bool isStored(std::uint64_t sequence) const;                // locked; also when dropped
    [[nodiscard]] std::optional<BagBatch> nextBatch();
    void commit(BagBatch batch);
    void settle(const BagBatch& batch);
    void refuse(BagBatch& batch, std::size_t index);
    void dropPictures(BagBatch& batch);
    [[nodiscard]] bool waitToRetry();
    void giveUp(const BagBatch& batch);

    void watch();
    [[nodiscard]] DiskReading reading();

    std::unique_ptr<BagStore> m_store;
    const BagWriterSettings m_settings;
    const BagWriter::AlarmHandler m_onAlarm;

    mutable std::mutex m_mutex;  // guards all below except the threads
    std::condition_variable m_wake, m_settled, m_watchWake;
    EventQueue m_queue;
    std::map<TopicKey, TopicUse> m_topics;  // known ones
    std::vector<TopicInfo> m_newTopics;
    std::size_t m_storedTopics = 0;  // of m_topics, on the disk
    std::uint64_t m_lastSequence = 0;
    std::uint64_t m_urgent = 0;     // last sequence that must not wait
    std::uint64_t m_takenFrom = 0;  // first sequence of the batch that is being committed
    Clock::time_point m_topicsCame{}, m_oldestTaken{}, m_lastMetadata{};
    bool m_committing = false, m_flushing = false, m_stopping = false, m_watchStopping = false;
    bool m_diskFull = false, m_closed = false;
    std::string m_failure;  // of the last attempt; empty: it did not fail
    std::uint64_t m_writtenEvents = 0, m_writtenBytes = 0, m_commits = 0, m_abandoned = 0;
    Time m_lastCommit{};
    double m_rate = 0.0, m_minutesLeft = std::numeric_limits<double>::infinity();

    std::jthread m_writer, m_watcher;  // last: joined first
};

}  // namespace leitstand::detail
