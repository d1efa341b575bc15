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

/// A topic of a bag, over all its files.
struct BagTopic {
    TopicInfo info;
    std::optional<std::uint64_t> messages;  ///< empty where nobody counted them; see BagReader::count()
};

/// A file of a bag: one session of the station that wrote it.
struct BagSession {
    std::filesystem::path file;
    std::uint64_t firstSequence = 0, lastSequence = 0;  ///< 0: no events
    Time first{}, last{};                               ///< receive times; epoch: no events
    std::optional<std::uint64_t> messages{};            ///< empty where nobody counted them
    /// Messages that were counted when they were written, and are not there any more.
    std::uint64_t missing = 0;
    bool closed = true;    ///< false: still written, or its writer was killed (what it committed is read)
    bool damaged = false;  ///< read page by page, since SQLite cannot; problems() tells what is missing
};

/// Which events to read, in their order.
struct BagQuery {
    std::uint64_t fromSequence = 0;                                        ///< first that may come
    std::uint64_t toSequence = std::numeric_limits<std::uint64_t>::max();  ///< last that may come
    std::optional<Time> from{};                                            ///< receive time, inclusive
    std::optional<Time> to{};                                              ///< receive time, exclusive
    std::vector<std::string> topics{};                                     ///< empty: all
};

/// Events of a bag, one after the other. Must not outlive its reader.
class BagCursor {
public:
    BagCursor(BagCursor&&) noexcept;
    BagCursor& operator=(BagCursor&&) noexcept;
    ~BagCursor();

    /// The next event; empty at the end. What cannot be read is skipped and told by BagReader::problems().
    [[nodiscard]] std::optional<RawEvent> next();

private:
    friend class BagReader;
    class Impl;
    explicit BagCursor(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// Reads rosbag2 SQLite bags, ours and others', damaged ones as far as they go. The files are never changed,
/// not even by replaying a write-ahead log that a killed writer left (docs/mission-log.md). One thread at a
/// time may use a reader and its cursors.
///
/// In our bags an event's sequence is the row's id, and order is by sequence. Other bags are ordered by
/// receive time, and their sequences are numbered on from file to file.
class BagReader {
public:
    /// Opens @p bag: a mission's folder, or one file of it. An error when nothing in it can be read, or when
    /// it is a bag of another kind (MCAP, compressed).
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
    /// Whether a station of ours wrote it.
    [[nodiscard]] bool ours() const;
    /// What could not be read so far, each naming file and place; grows as damaged parts are met.
    [[nodiscard]] const std::vector<std::string>& problems() const;

    /// Events that @p query asks for.
    [[nodiscard]] BagCursor read(const BagQuery& query = {});
    /// The event of @p sequence; empty when the bag has none.
    [[nodiscard]] std::optional<RawEvent> event(std::uint64_t sequence);
    /// The newest event of @p topic up to and with @p sequence; empty when there is none.
    [[nodiscard]] std::optional<RawEvent> lastUpTo(const std::string& topic, std::uint64_t sequence);
    /// The first sequence received at or after @p time; lastSequence() + 1 when there is none.
    [[nodiscard]] std::uint64_t sequenceAt(Time time);
    /// Counts the messages of topics that nobody counted before: reads a page of each, so may take long.
    void count();

private:
    friend class BagCursor;
    class Impl;
    explicit BagReader(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand
