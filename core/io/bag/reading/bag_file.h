#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "core/io/bag/topic_info.h"

namespace leitstand::detail {

/// A topic as one file describes it.
struct FileTopic {
    TopicInfo info;
    std::optional<std::uint64_t> messages;  ///< empty: not counted
};

/// A message of a file: a row of the table messages.
struct BagRow {
    std::uint64_t id = 0;
    std::int64_t topic = 0;  ///< key of BagFile::topics
    Time received{};
    Payload cdr;
};

/// Facts about one file of a bag.
struct BagFileFacts {
    std::map<std::int64_t, FileTopic> topics;  ///< topics by id
    std::uint64_t firstId = 0, lastId = 0;     ///< ids of messages; 0: there are none
    Time first{}, last{};                      ///< receive times
    /// Whether it is a bag of Leitstand, whose rows are ordered by id; in others, rows are ordered by time.
    bool ours = false;
    bool idsByTime = false;      ///< whether ids rise with the receive times
    bool closed = true;          ///< whether its writer finished it
    std::uint64_t expected = 0;  ///< number of messages in its own metadata; 0: not known
    std::vector<std::string> problems;

    /// Returns the number of all messages; empty when any topic has no count.
    [[nodiscard]] std::optional<std::uint64_t> messages() const {
        std::uint64_t sum = 0;
        for (const auto& [id, topic] : topics) {
            if (!topic.messages) return std::nullopt;
            sum += *topic.messages;
        }
        return sum;
    }
};

/// Which rows to read.
struct RowQuery {
    Time afterTime = Time::min();  ///< time of the last row that was read, if rows are ordered by time
    std::uint64_t afterId = 0;     ///< id of the last row that was read
    std::uint64_t lastId = std::numeric_limits<std::int64_t>::max();
    Time lastTime = Time::max();
    std::optional<std::set<std::int64_t>> topics;  ///< empty: all topics
};

/// One file of a bag: an SQLite database, read by SQLite or by our own code, or an MCAP file.
class BagFile {
public:
    virtual ~BagFile() = default;
    [[nodiscard]] const BagFileFacts& facts() const { return m_facts; }

    enum class Outcome { More, End, Broken };
    /// Appends the next rows to @p rows, a few dozen at most. Returns Broken when the file is damaged there.
    [[nodiscard]] virtual Outcome fetch(const RowQuery& query, std::vector<BagRow>& rows) = 0;
    /// Returns the row with the id @p id; empty when there is none. Sets @p broken when the file is damaged.
    [[nodiscard]] virtual std::optional<BagRow> row(std::uint64_t id, bool& broken) = 0;
    /// Returns the newest row of @p topics up to @p id (inclusive). Sets @p broken when the file is damaged.
    [[nodiscard]] virtual std::optional<BagRow> lastUpTo(const std::set<std::int64_t>& topics,
                                                         std::uint64_t id, bool& broken) = 0;
    /// Returns the first id received at or after @p time; 0 when there is none.
    [[nodiscard]] virtual std::uint64_t idAt(Time time, bool& broken) = 0;
    /// Counts the messages of each topic.
    virtual void count() = 0;
    /// Returns the problems found since the last call.
    [[nodiscard]] virtual std::vector<std::string> newProblems() { return {}; }

protected:
    BagFileFacts m_facts;
};

/// Largest valid id of a row. Larger sequences are kept free, since those of a bag continue from file to
/// file.
inline constexpr std::uint64_t MaxId = 1'000'000'000'000'000;

/// Largest size of a message [B]. Larger sizes in a damaged file are refused.
inline constexpr std::uint64_t MaxMessageBytes = 256U << 20U;

/// The limits of one fetch().
inline constexpr std::size_t FetchRows = 64, FetchBytes = 8U << 20U;

}  // namespace leitstand::detail
