#include "core/io/bag/reading/indexed_file.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/base/words.h"

namespace leitstand::detail {
namespace {

constexpr std::size_t MostKept = 96U << 20U;  ///< of unpacked chunks [B]; the newest is always kept
constexpr std::size_t MostChunks = 64;        ///< likewise, their number: they are searched one by one

}  // namespace

void IndexedFile::setEntries(std::vector<IndexEntry> entries) {
    m_entries = std::move(entries);
    std::stable_sort(m_entries.begin(), m_entries.end(), [](const IndexEntry& a, const IndexEntry& b) {
        return std::tie(a.received, a.chunk, a.offset) < std::tie(b.received, b.chunk, b.offset);
    });
    for (std::size_t number = 0; number < m_entries.size(); ++number)
        m_ofTopic[m_entries[number].topic].push_back(static_cast<std::uint32_t>(number));
    for (auto& [id, topic] : m_facts.topics) {
        const auto numbers = m_ofTopic.find(id);
        topic.messages = numbers == m_ofTopic.end() ? 0 : numbers->second.size();
    }
    m_facts.idsByTime = true;
    if (m_entries.empty()) return;
    m_facts.firstId = 1;
    m_facts.lastId = m_entries.size();
    m_facts.first = m_entries.front().received;
    m_facts.last = m_entries.back().received;
}

void IndexedFile::report(const std::string& what) {
    std::string text = m_file.string() + ": " + what;
    if (m_reported.insert(text).second) m_new.push_back(std::move(text));
}

std::vector<std::string> IndexedFile::newProblems() {
    return std::exchange(m_new, {});
}

IndexedFile::Records IndexedFile::recordsOf(std::uint32_t chunk) {
    const auto known =
        std::find_if(m_chunks.begin(), m_chunks.end(), [&](const auto& one) { return one.first == chunk; });
    if (known != m_chunks.end()) {
        m_chunks.splice(m_chunks.begin(), m_chunks, known);
        return m_chunks.front().second;
    }
    m_chunks.emplace_front(chunk, std::make_shared<const std::vector<std::byte>>(unpackedChunk(chunk)));
    if (m_chunks.size() > MostChunks) m_chunks.pop_back();
    std::size_t kept = 0;
    for (auto one = m_chunks.begin(); one != m_chunks.end();) {
        kept += one->second->size();
        one = kept > MostKept && one != m_chunks.begin() ? m_chunks.erase(one) : std::next(one);
    }
    return m_chunks.front().second;
}

std::optional<BagRow> IndexedFile::rowAt(std::size_t number) {
    const IndexEntry& entry = m_entries[number];
    auto payload = payloadAt(entry);
    if (!payload) {
        // A chunk that cannot be read has a problem of its own.
        if (entry.chunk == IndexEntry::NoChunk || !recordsOf(entry.chunk)->empty())
            report(
                leitstand::fill(translate("leitstand::Error",
                                          "message {}: expected a message where the index says, found none"),
                                number + 1));
        return std::nullopt;
    }
    return BagRow{number + 1, entry.topic, entry.received, std::move(*payload)};
}

BagFile::Outcome IndexedFile::fetch(const RowQuery& query, std::vector<BagRow>& rows) {
    const auto first =
        std::lower_bound(m_entries.begin(), m_entries.end(), query.afterTime,
                         [](const IndexEntry& entry, Time time) { return entry.received < time; });
    std::uint64_t number = std::max(static_cast<std::uint64_t>(first - m_entries.begin()), query.afterId);
    std::size_t bytes = 0, taken = 0;
    for (; number < m_entries.size() && number < query.lastId; ++number) {
        const IndexEntry& entry = m_entries[number];
        if (entry.received > query.lastTime) return Outcome::End;
        if (query.topics && !query.topics->contains(entry.topic)) continue;
        auto row = rowAt(static_cast<std::size_t>(number));
        if (!row) continue;
        bytes += row->cdr->size();
        rows.push_back(std::move(*row));
        if (++taken >= FetchRows || bytes >= FetchBytes) return Outcome::More;
    }
    return Outcome::End;
}

std::optional<BagRow> IndexedFile::row(std::uint64_t id, bool& /*broken*/) {
    return id == 0 || id > m_entries.size() ? std::nullopt : rowAt(static_cast<std::size_t>(id - 1));
}

std::optional<BagRow> IndexedFile::lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
                                            bool& /*broken*/) {
    for (std::uint64_t upTo = id; upTo > 0;) {
        std::uint64_t newest = 0;  // id of the newest message of one of the topics
        for (const std::int64_t topic : topics) {
            const auto numbers = m_ofTopic.find(topic);
            if (numbers == m_ofTopic.end()) continue;
            const auto after = std::lower_bound(numbers->second.begin(), numbers->second.end(), upTo);
            if (after != numbers->second.begin())
                newest = std::max<std::uint64_t>(newest, *std::prev(after) + 1ULL);
        }
        if (newest == 0) return std::nullopt;
        if (auto row = rowAt(static_cast<std::size_t>(newest - 1))) return row;
        upTo = newest - 1;  // it cannot be read: the one before
    }
    return std::nullopt;
}

std::uint64_t IndexedFile::idAt(Time time, bool& /*broken*/) {
    const auto found = std::lower_bound(m_entries.begin(), m_entries.end(), time,
                                        [](const IndexEntry& entry, Time at) { return entry.received < at; });
    return found == m_entries.end() ? 0 : static_cast<std::uint64_t>(found - m_entries.begin()) + 1;
}

}  // namespace leitstand::detail
