#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "core/io/bag/bag_storage.h"
#include "core/io/bag/topic_info.h"

namespace leitstand {

/// How a BagWriter commits and queues, and when it warns.
struct BagWriterSettings {
    /// Empty: as the earlier sessions are stored; the first one in SQLite.
    std::optional<BagStorage> storage{};
    /// Longest time that an event waits until it is committed.
    std::chrono::milliseconds commitInterval{400};
    std::size_t commitBytes = 16U << 20U;  ///< approximate largest size of a commit [B]
    /// Pictures are dropped while more than this is queued [B].
    std::size_t droppableQueueBytes = 64U << 20U;
    /// If more than this is queued, other events are lost, which is reported [B].
    std::size_t queueBytes = 512U << 20U;
    std::chrono::milliseconds metadataInterval{10'000};  ///< time between updates of metadata.yaml
    std::chrono::milliseconds retryInterval{500};        ///< time between attempts while the disk is full
    double alarmMinutes = 10.0;  ///< an alarm is raised if the disk will be full within this time [min]
};

/// A problem with the disk that the operator must know about. Reported when it begins and when it ends.
struct BagAlarm {
    enum class Kind : std::uint8_t {
        DiskFilling,  ///< the disk will be full within BagWriterSettings::alarmMinutes
        DiskSlow,     ///< the disk is too slow: pictures are dropped
        DiskFull,     ///< nothing can be written; events wait in memory
        EventsLost,   ///< the queue is full: events other than pictures are lost
        Failed,       ///< the file cannot be written for another reason, which the text names
    };
    Kind kind = Kind::DiskFilling;
    bool raised = true;        ///< false: it has ended
    double minutesLeft = 0.0;  ///< time until the disk is full; infinite when nothing is written [min]
    std::string text;          ///< text for the log (log_format.h); at the end of the alarm, it says so
};

/// State and figures of a writer.
struct BagWriterStatistics {
    double bytesPerSecond = 0.0;  ///< committed payload, mean over the last seconds
    std::size_t queuedEvents = 0, queuedBytes = 0;
    std::uint64_t writtenEvents = 0, writtenBytes = 0;  ///< committed in this session
    std::map<std::string, std::uint64_t> dropped;  ///< number of events that will never be written, by topic
    std::uint64_t commits = 0;
    Time lastCommit{};  ///< station's clock; epoch: none yet
    double minutesLeft = std::numeric_limits<double>::infinity();
    std::string problem;  ///< why nothing can be written at present; empty: there is no problem
};

namespace detail {
class BagStore;
}

/// Writes one session of a mission into its folder, which is a rosbag2 bag (docs/design.md, "The mission
/// log"; docs/mission-log.md). The writer has its own thread for writing. Any thread may call any function;
/// only open(), flush() and close() wait for the disk.
class BagWriter {
public:
    /// Called on a thread of the writer; must not call close().
    using AlarmHandler = std::function<void(const BagAlarm&)>;

    /// Opens a new session in the folder @p mission, which is made if it is missing. Reads the files of
    /// earlier sessions and never writes to them. Error when another writer has the mission, when its earlier
    /// sessions are stored in another kind of files than @p settings ask for, or when it cannot be written.
    [[nodiscard]] static Result<std::unique_ptr<BagWriter>> open(const std::filesystem::path& mission,
                                                                 const BagWriterSettings& settings = {},
                                                                 AlarmHandler onAlarm = {});
    /// Writes to @p store instead, for slow and full disks in tests.
    [[nodiscard]] static std::unique_ptr<BagWriter> over(std::unique_ptr<detail::BagStore> store,
                                                         const BagWriterSettings& settings,
                                                         AlarmHandler onAlarm = {});
    ~BagWriter();  ///< does the same as close()
    BagWriter(const BagWriter&) = delete;
    BagWriter& operator=(const BagWriter&) = delete;

    /// Announces a topic. A topic that was not announced is stored without its definition.
    void addTopic(const TopicInfo& topic);
    /// Queues @p event. Its sequence must be higher than all earlier ones; 0: the writer assigns it. If its
    /// sequence is not higher, or if the queue is too long, the event is dropped and counted.
    void write(RawEvent event);

    [[nodiscard]] BagWriterStatistics statistics() const;
    /// The file of this session.
    [[nodiscard]] const std::filesystem::path& file() const;
    /// Last sequence of earlier sessions. The events of this session have higher sequences.
    [[nodiscard]] std::uint64_t earlierSequence() const;

    /// Waits until everything queued before the call is on the disk. Error when that takes longer than
    /// @p deadline.
    [[nodiscard]] Result<void> flush(std::chrono::milliseconds deadline = std::chrono::seconds(10));
    /// Writes everything that is queued, makes the file self-contained and metadata.yaml final. Events for
    /// which a full disk has no space are lost; the error says how many. Later calls do nothing.
    [[nodiscard]] Result<void> close();

private:
    class Impl;
    explicit BagWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand
