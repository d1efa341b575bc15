#include "core/io/bag/mcap/mcap_index.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/words.h"
#include "core/io/bag/mcap/mcap_sequences.h"

namespace leitstand::detail {
namespace {

constexpr std::uint64_t MostSummary = 512U << 20U;  ///< [B]
constexpr std::size_t FooterLength = 20;            ///< of its content [B]

/// Builds the index of a file.
class Indexing {
public:
    explicit Indexing(McapBytes& bytes, McapIndex index = {}) : m_bytes(bytes), m_index(std::move(index)) {}

    /// Reads by the summary; false when there is none, or it does not show all messages.
    [[nodiscard]] bool bySummary();
    /// Reads the file record by record.
    void byRecords();
    /// See extendMcapIndex().
    [[nodiscard]] std::uint64_t extend(std::uint64_t from);
    [[nodiscard]] McapIndex finish();

private:
    /// A chunk whose message indexes may follow.
    struct Open {
        std::uint32_t chunk = 0;
        std::uint64_t at = 0;  ///< offset of its record in the file [B]
        bool indexed = false;
        std::vector<IndexEntry> entries;
        McapSequences sequences;
    };
    void describe(McapOp op, std::span<const std::byte> content);
    void add(std::vector<IndexEntry>& entries, std::span<const std::byte> messageIndex,
             std::uint32_t chunk) const;
    void keep(std::vector<IndexEntry> entries);
    /// Keeps @p entries of one chunk, in our missions with their @p sequences.
    void keep(std::vector<IndexEntry> entries, const McapSequences& sequences, std::uint64_t at);
    /// Gives all entries of a mission the sequences in the summary; false when there is one too many or too
    /// few.
    [[nodiscard]] bool takeSequences(const McapSequences& sequences);
    /// Reads the messages of @p open, when no index shows them; always what it describes.
    void close(Open& open);
    [[nodiscard]] std::vector<IndexEntry> scan(std::uint32_t chunk, std::uint64_t at, bool messages);
    void problem(std::uint64_t at, const std::string& what);

    McapBytes& m_bytes;
    McapIndex m_index;
    bool m_full = false;  ///< MostEntries was reached
};

void Indexing::problem(std::uint64_t at, const std::string& what) {
    m_index.problems.push_back(leitstand::fill(translate("leitstand::Error", "byte {}: {}"), at, what));
}

void Indexing::describe(McapOp op, std::span<const std::byte> content) {
    if (op == McapOp::Schema) {
        if (auto schema = mcapSchema(content)) m_index.schemas.try_emplace(schema->id, std::move(*schema));
    } else if (op == McapOp::Channel) {
        if (auto channel = mcapChannel(content))
            m_index.channels.try_emplace(channel->id, std::move(*channel));
    } else if (op == McapOp::Statistics) {
        m_index.stated = mcapMessageCount(content);
    }
}

void Indexing::add(std::vector<IndexEntry>& entries, std::span<const std::byte> messageIndex,
                   std::uint32_t chunk) const {
    McapFields fields(messageIndex);
    const std::uint16_t channel = fields.u16();
    McapFields pairs(fields.bytes());
    while (pairs.ok() && !pairs.rest().empty()) {
        const Time logged = mcapTime(pairs.u64());
        const std::uint64_t offset = pairs.u64();
        if (pairs.ok()) entries.push_back({logged, offset, chunk, channel});
    }
}

void Indexing::keep(std::vector<IndexEntry> entries) {
    const std::size_t room = MostEntries - std::min(MostEntries, m_index.entries.size());
    if (entries.size() > room) {
        entries.resize(room);
        if (!std::exchange(m_full, true))
            m_index.problems.push_back(leitstand::fill(
                translate("leitstand::Error", "expected at most {} messages; those after them are left out"),
                MostEntries));
    }
    m_index.entries.insert(m_index.entries.end(), entries.begin(), entries.end());
}

void Indexing::keep(std::vector<IndexEntry> entries, const McapSequences& sequences, std::uint64_t at) {
    if (!m_index.ours) return keep(std::move(entries));
    std::sort(entries.begin(), entries.end(),
              [](const IndexEntry& a, const IndexEntry& b) { return a.offset < b.offset; });
    if (entries.size() > sequences.count()) {
        problem(at, leitstand::fill(
                        translate("leitstand::Error",
                                  "expected sequences of {} messages, found {}; the others are left out"),
                        entries.size(), sequences.count()));
        entries.resize(sequences.count());
    }
    const std::size_t before = m_index.entries.size();
    keep(std::move(entries));
    const auto numbers = sequences.first(m_index.entries.size() - before);
    m_index.sequences.insert(m_index.sequences.end(), numbers.begin(), numbers.end());
}

bool Indexing::takeSequences(const McapSequences& sequences) {
    if (sequences.count() != m_index.entries.size()) return false;
    std::sort(m_index.entries.begin(), m_index.entries.end(), [](const IndexEntry& a, const IndexEntry& b) {
        return std::tie(a.chunk, a.offset) < std::tie(b.chunk, b.offset);
    });
    m_index.sequences = sequences.first(sequences.count());
    return true;
}

bool Indexing::bySummary() {
    constexpr std::size_t Tail = McapRecordHead + FooterLength + McapMagic.size();
    if (m_bytes.size() < Tail + McapMagic.size()) return false;
    const std::uint64_t end = m_bytes.size() - Tail;
    const auto tail = m_bytes.at(end, Tail);
    if (tail.size() < Tail) return false;
    const auto magic = tail.last(McapMagic.size());
    const McapHead head = mcapHead(tail.first(McapRecordHead));
    if (std::string_view(reinterpret_cast<const char*>(magic.data()), magic.size()) != McapMagic ||
        head.op != McapOp::Footer || head.length != FooterLength)
        return false;
    m_index.closed = true;
    const auto footer = mcapFooter(tail.subspan(McapRecordHead, FooterLength));
    if (!footer || footer->summary == 0 || footer->summary >= end || end - footer->summary > MostSummary)
        return false;
    std::vector<McapChunkIndex> chunks;
    std::optional<McapSequences> sequences;
    forEachRecord(m_bytes.at(footer->summary, end - footer->summary),
                  [&](McapOp op, std::size_t, std::span<const std::byte> content) {
                      describe(op, content);
                      if (op == McapOp::Sequences && !sequences)
                          sequences = McapSequences::parse(content, MostEntries);
                      if (op != McapOp::ChunkIndex) return;
                      if (const auto one = mcapChunkIndex(content)) chunks.push_back(*one);
                  });
    m_index.ours = sequences.has_value();
    if (chunks.empty()) return m_index.stated == 0U;
    std::sort(chunks.begin(), chunks.end(),
              [](const McapChunkIndex& a, const McapChunkIndex& b) { return a.chunk < b.chunk; });
    std::uint64_t behind = 0;  // the chunk before
    for (const McapChunkIndex& one : chunks) {
        if (m_full) break;
        const bool fits = one.chunk >= behind && one.length > McapRecordHead && one.chunk < m_bytes.size() &&
                          one.length <= m_bytes.size() - one.chunk &&
                          one.indexes <= m_bytes.size() - one.chunk - one.length;
        if (!fits) return false;
        behind = one.chunk + one.length + one.indexes;
        const auto number = static_cast<std::uint32_t>(m_index.chunks.size());
        m_index.chunks.push_back({one.chunk + McapRecordHead, one.length - McapRecordHead});
        if (one.indexes == 0) {
            keep(scan(number, one.chunk, true));
            continue;
        }
        std::vector<IndexEntry> entries;
        forEachRecord(m_bytes.at(one.chunk + one.length, one.indexes),
                      [&](McapOp op, std::size_t, std::span<const std::byte> content) {
                          if (op == McapOp::MessageIndex) add(entries, content, number);
                      });
        keep(std::move(entries));
    }
    const bool known =
        std::all_of(m_index.entries.begin(), m_index.entries.end(), [&](const IndexEntry& one) {
            return m_index.channels.contains(static_cast<std::uint16_t>(one.topic));
        });
    if (!known || (!m_full && m_index.entries.size() < m_index.stated.value_or(0))) return false;
    return !sequences || takeSequences(*sequences);
}

std::vector<IndexEntry> Indexing::scan(std::uint32_t chunk, std::uint64_t at, bool messages) {
    const McapRecords records = m_bytes.recordsAt(m_index.chunks[chunk]);
    if (!records.problem.empty()) problem(at, records.problem);
    std::vector<IndexEntry> entries;
    forEachRecord(records.bytes, [&](McapOp op, std::size_t offset, std::span<const std::byte> content) {
        describe(op, content);
        const auto message = messages && op == McapOp::Message ? mcapMessage(content) : std::nullopt;
        if (message) entries.push_back({message->logged, offset, chunk, message->channel});
    });
    return entries;
}

void Indexing::close(Open& open) {
    const bool unknown = std::any_of(open.entries.begin(), open.entries.end(), [&](const IndexEntry& one) {
        return !m_index.channels.contains(static_cast<std::uint16_t>(one.topic));
    });
    if (!open.indexed || unknown) {
        auto found = scan(open.chunk, open.at, !open.indexed);
        if (!open.indexed) open.entries = std::move(found);
    }
    keep(std::move(open.entries), open.sequences, open.at);
}

void Indexing::byRecords() {
    McapIndex begun;
    begun.closed = m_index.closed;
    begun.stated = m_index.stated;
    m_index = std::move(begun);
    m_full = false;
    std::optional<Open> open;
    McapSequences sequences;        // of the chunk that comes next
    std::vector<IndexEntry> loose;  // messages outside of chunks
    std::uint64_t at = McapMagic.size();
    while (at < m_bytes.size() && !m_full) {
        const auto bytes = m_bytes.at(at, McapRecordHead);
        const bool ends = bytes.size() == McapMagic.size() && bytes[0] == std::byte{0x89};
        if (ends && m_index.closed) break;
        const McapHead head = bytes.size() == McapRecordHead ? mcapHead(bytes) : McapHead{};
        const std::uint64_t left =
            m_bytes.size() - at - std::min<std::uint64_t>(McapRecordHead, m_bytes.size() - at);
        const bool cut = bytes.size() < McapRecordHead || head.length > left;
        if (open && head.op != McapOp::MessageIndex && (!cut || head.op == McapOp::Chunk)) {
            close(*open);
            open.reset();
        }
        if (head.op == McapOp::DataEnd || head.op == McapOp::Footer) break;
        const std::uint64_t length = std::min(head.length, left);
        if (head.op == McapOp::Chunk) {
            m_index.chunks.push_back({at + McapRecordHead, length});
            open = Open{static_cast<std::uint32_t>(m_index.chunks.size() - 1),
                        at,
                        false,
                        {},
                        std::exchange(sequences, {})};
        } else if (!cut && open && head.op == McapOp::MessageIndex) {
            open->indexed = true;
            add(open->entries, m_bytes.at(at + McapRecordHead, length), open->chunk);
        } else if (!cut && head.op == McapOp::Sequences) {
            if (auto found = McapSequences::parse(m_bytes.at(at + McapRecordHead, length), MostEntries)) {
                sequences = std::move(*found);
                m_index.ours = true;
            }
        } else if (!cut && head.op == McapOp::Message) {
            constexpr std::uint64_t Fields = 22;  // before a message's data [B]
            const auto message = mcapMessage(m_bytes.at(at + McapRecordHead, std::min(length, Fields)));
            if (message) loose.push_back({message->logged, at, IndexEntry::NoChunk, message->channel});
        } else if (!cut) {
            describe(head.op, head.op == McapOp::Schema || head.op == McapOp::Channel
                                  ? m_bytes.at(at + McapRecordHead, length)
                                  : std::span<const std::byte>());
        }
        if (cut) {
            problem(at, translate("leitstand::Error",
                                  "the file ends within this record: what follows is missing"));
            break;
        }
        at += McapRecordHead + head.length;
    }
    if (open) {
        // The writer was killed there: some of the indexes may be missing.
        open->indexed = false;
        open->entries.clear();
        close(*open);
    }
    keep(std::move(loose), {}, 0);
    // Of a mission, the session says so, and nothing needs to be missing.
    if (!m_index.closed && !m_index.ours && m_index.problems.empty())
        m_index.problems.push_back(translate("leitstand::Error", "its writer did not finish it"));
}

std::uint64_t Indexing::extend(std::uint64_t from) {
    McapSequences sequences;
    std::optional<Open> open;
    std::uint64_t whole = from;  // up to where everything was taken
    for (std::uint64_t at = from;;) {
        const auto bytes = m_bytes.at(at, McapRecordHead);
        const McapHead head = bytes.size() == McapRecordHead ? mcapHead(bytes) : McapHead{McapOp::DataEnd, 0};
        const std::uint64_t content = at + McapRecordHead;
        if (head.op == McapOp::DataEnd || head.length > m_bytes.size() - content) break;
        if (head.op == McapOp::Sequences) {
            auto found = McapSequences::parse(m_bytes.at(content, head.length), MostEntries);
            sequences = found ? std::move(*found) : McapSequences();
        } else if (head.op == McapOp::Chunk) {
            m_index.chunks.push_back({content, head.length});
            open = Open{static_cast<std::uint32_t>(m_index.chunks.size() - 1),
                        at,
                        true,
                        {},
                        std::exchange(sequences, {})};
        } else if (head.op == McapOp::MessageIndex && open) {
            add(open->entries, m_bytes.at(content, head.length), open->chunk);
        }
        at = content + head.length;
        if (head.op == McapOp::Sequences || (open && open->entries.size() < open->sequences.count()))
            continue;
        if (open) {
            open->indexed = open->sequences.count() > 0;  // one without messages describes topics
            close(*open);
            open.reset();
        }
        whole = at;
    }
    if (open) m_index.chunks.pop_back();  // it is not whole yet
    return whole;
}

McapIndex Indexing::finish() {
    return std::move(m_index);
}

}  // namespace

std::size_t forEachRecord(std::span<const std::byte> records,
                          const std::function<void(McapOp, std::size_t, std::span<const std::byte>)>& take) {
    std::size_t at = 0;
    while (records.size() - at >= McapRecordHead) {
        const McapHead head = mcapHead(records.subspan(at, McapRecordHead));
        if (head.length > records.size() - at - McapRecordHead) break;
        const auto length = static_cast<std::size_t>(head.length);
        take(head.op, at, records.subspan(at + McapRecordHead, length));
        at += McapRecordHead + length;
    }
    return at;
}

std::uint64_t extendMcapIndex(McapBytes& bytes, McapIndex& index, std::uint64_t from) {
    index.ours = true;
    Indexing indexing(bytes, std::move(index));
    const std::uint64_t end = indexing.extend(from);
    index = indexing.finish();
    return end;
}

McapIndex mcapIndexOf(McapBytes& bytes) {
    Indexing indexing(bytes);
    if (!indexing.bySummary()) indexing.byRecords();
    return indexing.finish();
}

}  // namespace leitstand::detail
