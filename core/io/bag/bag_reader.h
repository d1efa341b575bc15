#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "core/io/bag/topic_info.h"

namespace leitstand {

/// A topic of a bag, in all its files.
struct BagTopic {
    TopicInfo info;
    std::optional<std::uint64_t> messages;  ///< empty: not counted; see BagReader::count()
};

/// A file of a bag: one session of the station that wrote it.
struct BagSession {
    std::filesystem::path file;
    std::uint64_t firstSequence = 0, lastSequence = 0;  ///< 0: no events
    Time first{}, last{};                               ///< receive times; epoch: no events
    std::optional<std::uint64_t> messages{};            ///< empty: not counted
    /// Number of messages that were counted when they were written, and are no longer in the file.
    std::uint64_t missing = 0;
    bool closed = true;  ///< false: a writer has it open, or was killed (what it committed is read)
    /// SQLite cannot read it, so its pages are read here; problems() lists what is missing.
    bool damaged = false;
};

/// Which events to read.
struct BagQuery {
    std::uint64_t fromSequence = 0;                                        ///< first sequence
    std::uint64_t toSequence = std::numeric_limits<std::uint64_t>::max();  ///< last sequence, inclusive
    std::optional<Time> from{};                                            ///< first receive time, inclusive
    std::optional<Time> to{};                                              ///< last receive time, exclusive
    std::vector<std::string> topics{};                                     ///< empty: all topics
};

/// Reads events of a bag one after the other. Must not outlive its reader.
class BagCursor {
public:
    BagCursor(BagCursor&&) noexcept;
    BagCursor& operator=(BagCursor&&) noexcept;
    ~BagCursor();

    /// Returns the next event; empty at the end. Skips what cannot be read; BagReader::problems() lists it.
    [[nodiscard]] std::optional<RawEvent> next();

private:
    friend class BagReader;
    class Impl;
    explicit BagCursor(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// Reads rosbag2 bags in SQLite and MCAP files, ours and others', and damaged ones as far as possible. Never
/// changes the files, not even to apply a write-ahead log that a killed writer left (docs/mission-log.md).
/// Only one thread at a time may use a reader and its cursors.
///
/// In our bags, the sequence of an event is the id of its row, and events are read by rising sequence. Events
/// of other bags are read by receive time, and their sequences continue from file to file.
class BagReader {
public:
    /// Opens @p bag: the folder of a mission, or one of its files. Error when nothing in it can be read, or
    /// when the bag is of another kind (ROS 1, files compressed by zstd).
    [[nodiscard]] static Result<std::unique_ptr<BagReader>> open(const std::filesystem::path& bag);
    ~BagReader();
    BagReader(const BagReader&) = delete;
    BagReader& operator=(const BagReader&) = delete;

    /// The files in order of time.
    [[nodiscard]] const std::vector<BagSession>& sessions() const;
    /// All topics, by name.
    [[nodiscard]] const std::vector<BagTopic>& topics() const;
    [[nodiscard]] std::uint64_t lastSequence() const;  ///< 0: no events
    [[nodiscard]] Time first() const;                  ///< earliest receive time; epoch: no events
    [[nodiscard]] Time last() const;
    /// Whether a Leitstand station wrote the bag.
    [[nodiscard]] bool ours() const;
    /// Problems so far, each with file and place. The list grows as damaged parts are read.
    [[nodiscard]] const std::vector<std::string>& problems() const;

    /// Returns a cursor over the events that match @p query.
    [[nodiscard]] BagCursor read(const BagQuery& query = {});
    /// Returns the event with the sequence @p sequence; empty when the bag has none.
    [[nodiscard]] std::optional<RawEvent> event(std::uint64_t sequence);
    /// Returns the newest event of @p topic up to and including @p sequence; empty when there is none.
    [[nodiscard]] std::optional<RawEvent> lastUpTo(const std::string& topic, std::uint64_t sequence);
    /// Returns the first sequence received at or after @p time; lastSequence() + 1 when there is none.
    [[nodiscard]] std::uint64_t sequenceAt(Time time);
    /// Counts the messages of topics that have no count. Reads a page for each message, so it may take long.
    void count();

private:
    friend class BagCursor;
    class Impl;
    explicit BagReader(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand
