#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "core/io/bag/topic_info.h"

namespace leitstand {

/// How a BagWriter commits, queues and warns.
struct BagWriterSettings {
    std::chrono::milliseconds commitInterval{400};  ///< an event waits at most this long for its commit
    std::size_t commitBytes = 16U << 20U;           ///< a commit holds at most about this much [B]
    std::size_t droppableQueueBytes = 64U << 20U;   ///< pictures are dropped while more is queued [B]
    std::size_t queueBytes = 512U << 20U;           ///< other events are lost and reported beyond this [B]
    std::chrono::milliseconds metadataInterval{10'000};  ///< between updates of metadata.yaml
    std::chrono::milliseconds retryInterval{500};        ///< between attempts on a full disk
    double alarmMinutes = 10.0;  ///< an alarm is raised when the disk lasts less than this [min]
};

/// A disk problem that the operator must know about. Reported when it begins, and again when it is over.
struct BagAlarm {
    enum class Kind : std::uint8_t {
        DiskFilling,  ///< the disk lasts less than BagWriterSettings::alarmMinutes
        DiskSlow,     ///< the disk does not keep up: pictures are dropped
        DiskFull,     ///< nothing can be written; events wait in memory
        EventsLost,   ///< the queue is full: events other than pictures are lost
        Failed,       ///< the file cannot be written for another reason, which the text names
    };
    Kind kind = Kind::DiskFilling;
    bool raised = true;        ///< false: over
    double minutesLeft = 0.0;  ///< until the disk is full; infinite when nothing is written [min]
    std::string text;          ///< as the log holds it (log_format.h); states the end when the alarm is over
};

/// State and figures of a writer.
struct BagWriterStatistics {
    double bytesPerSecond = 0.0;  ///< payload committed, mean over the last seconds
    std::size_t queuedEvents = 0, queuedBytes = 0;
    std::uint64_t writtenEvents = 0, writtenBytes = 0;  ///< committed in this session
    std::map<std::string, std::uint64_t> dropped;       ///< events per topic that will never be written
    std::uint64_t commits = 0;
    Time lastCommit{};  ///< station's clock; epoch before the first
    double minutesLeft = std::numeric_limits<double>::infinity();
    std::string problem;  ///< why nothing can be written at present; empty when all is well
};

namespace detail {
class BagStore;
}

/// Writes one session of a mission into its folder, a rosbag2 bag (docs/design.md, "The mission log";
/// docs/mission-log.md). A thread of the writer does the writing. Any thread may call any function; only
/// open(), flush() and close() wait for the disk.
class BagWriter {
public:
    /// Called on a thread of the writer; must not call close().
    using AlarmHandler = std::function<void(const BagAlarm&)>;

    /// Opens a new session in folder @p mission and makes the folder if absent. Reads the files of earlier
    /// sessions and never writes them. Error when another writer has the mission, or it cannot be written.
    [[nodiscard]] static Result<std::unique_ptr<BagWriter>> open(const std::filesystem::path& mission,
                                                                 const BagWriterSettings& settings = {},
                                                                 AlarmHandler onAlarm = {});
    /// Writes into @p store instead; for slow and full disks in tests.
    [[nodiscard]] static std::unique_ptr<BagWriter> over(std::unique_ptr<detail::BagStore> store,
                                                         const BagWriterSettings& settings,
                                                         AlarmHandler onAlarm = {});
    ~BagWriter();  ///< as close()
    BagWriter(const BagWriter&) = delete;
    BagWriter& operator=(const BagWriter&) = delete;

    /// Announces a topic. A topic that is not announced is stored without its definition.
    void addTopic(const TopicInfo& topic);
    /// Queues @p event. Its sequence must be higher than all before; 0: the writer numbers it. The event is
    /// dropped and counted when its sequence is not higher, or when the queue is too long.
    void write(RawEvent event);

    [[nodiscard]] BagWriterStatistics statistics() const;
    /// The file of this session.
    [[nodiscard]] const std::filesystem::path& file() const;
    /// Last sequence of earlier sessions; the events of this session begin after it.
    [[nodiscard]] std::uint64_t earlierSequence() const;

    /// Waits until everything queued before the call is on the disk. Error when that takes longer than
    /// @p deadline.
    [[nodiscard]] Result<void> flush(std::chrono::milliseconds deadline = std::chrono::seconds(10));
    /// Writes what is queued, makes the file self-contained and metadata.yaml final. Events that a full disk
    /// cannot take are lost; the error reports how many. Later calls do nothing.
    [[nodiscard]] Result<void> close();

private:
    class Impl;
    explicit BagWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand
