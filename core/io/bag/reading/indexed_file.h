#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/time.h"
#include "core/io/bag/reading/bag_file.h"

namespace leitstand::detail {

/// Where a message is in its file.
struct IndexEntry {
    static constexpr std::uint32_t NoChunk = std::numeric_limits<std::uint32_t>::max();

    Time received{};
    /// Offset of its record: within the records of its chunk, or within the file if it is in no chunk [B].
    std::uint64_t offset = 0;
    std::uint32_t chunk = NoChunk;  ///< number of its chunk in the file, from 0
    std::uint32_t topic = 0;        ///< key of BagFileFacts::topics
};

/// Largest number of messages in a file. The index takes 28 bytes of memory for each.
inline constexpr std::size_t MostEntries = 40'000'000;

/// A file whose messages are found by an index in memory. They have ids from 1 in the order of their receive
/// times, or in a mission those that its writer gave them.
class IndexedFile : public BagFile {
public:
    [[nodiscard]] Outcome fetch(const RowQuery& query, std::vector<BagRow>& rows) override;
    [[nodiscard]] std::optional<BagRow> row(std::uint64_t id, bool& broken) override;
    [[nodiscard]] std::optional<BagRow> lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
                                                 bool& broken) override;
    [[nodiscard]] std::uint64_t idAt(Time time, bool& broken) override;
    void count() override {}  // counted when opened
    [[nodiscard]] std::vector<std::string> newProblems() override;

protected:
    using Records = std::shared_ptr<const std::vector<std::byte>>;

    explicit IndexedFile(std::filesystem::path file) : m_file(std::move(file)) {}
    /// Takes the index, in any order, and sets the facts that follow from it. The facts' topics must be
    /// known. Entries of the same time stay in the order of their places.
    void setEntries(std::vector<IndexEntry> entries);
    /// The same for a mission's file, whose entries have the ids @p ids, in the same order.
    void setEntries(std::vector<IndexEntry> entries, std::vector<std::uint64_t> ids);
    /// Adds entries to a mission's file that is being written. Those whose ids do not rise are left out.
    void addEntries(const std::vector<IndexEntry>& entries, const std::vector<std::uint64_t>& ids);
    /// Returns the records of chunk @p chunk. The chunks that were used last stay in memory.
    [[nodiscard]] Records recordsOf(std::uint32_t chunk);
    /// Reports @p what through newProblems(), with the file's name, once.
    void report(const std::string& what);
    [[nodiscard]] const std::filesystem::path& file() const { return m_file; }

private:
    /// Returns the bytes of the message at @p entry. Empty: there is none.
    [[nodiscard]] virtual std::optional<Payload> payloadAt(const IndexEntry& entry) = 0;
    /// Called before each query: adds what was written since. Of files that nobody writes: nothing.
    virtual void lookAgain() {}
    /// Reads and unpacks chunk @p chunk, as far as it can be read; reports what is wrong with it.
    [[nodiscard]] virtual std::vector<std::byte> unpackedChunk(std::uint32_t chunk) = 0;
    /// Lists the entries from number @p first on with their topics, and sets the facts that follow.
    void listFrom(std::size_t first);
    /// Returns the message of entry @p number, from 0. Empty: it cannot be read, which is reported.
    [[nodiscard]] std::optional<BagRow> rowAt(std::size_t number);
    [[nodiscard]] std::uint64_t idOf(std::size_t number) const;
    /// Returns how many entries have ids up to @p id.
    [[nodiscard]] std::size_t countUpTo(std::uint64_t id) const;

    std::filesystem::path m_file;
    std::vector<IndexEntry> m_entries;  ///< by time; of a mission by id
    std::vector<std::uint64_t> m_ids;   ///< of the entries of a mission, rising; empty: they count from 1
    std::map<std::int64_t, std::vector<std::uint32_t>> m_ofTopic;  ///< rising numbers of entries, by topic
    std::list<std::pair<std::uint32_t, Records>> m_chunks;         ///< chunks in memory, newest use first
    std::set<std::string> m_reported;
    std::vector<std::string> m_new;
};

}  // namespace leitstand::detail
