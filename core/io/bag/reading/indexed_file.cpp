#include "core/io/bag/reading/indexed_file.h"

#include <algorithm>
#include <iterator>
#include <numeric>
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
    m_facts.idsByTime = true;
    listFrom(0);
}

void IndexedFile::setEntries(std::vector<IndexEntry> entries, std::vector<std::uint64_t> ids) {
    std::vector<std::uint32_t> order(std::min(entries.size(), ids.size()));
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return ids[a] < ids[b]; });
    for (const std::uint32_t number : order) {
        if (!m_ids.empty() && ids[number] == m_ids.back()) continue;
        m_ids.push_back(ids[number]);
        m_entries.push_back(entries[number]);
    }
    if (m_ids.size() < entries.size())
        m_facts.problems.push_back(
            leitstand::fill(translate("leitstand::Error",
                                      "{}: expected a sequence of its own for each message; {} are left out"),
                            m_file.string(), entries.size() - m_ids.size()));
    m_facts.ours = true;
    listFrom(0);
}

void IndexedFile::addEntries(const std::vector<IndexEntry>& entries, const std::vector<std::uint64_t>& ids) {
    const std::size_t before = m_entries.size();
    for (std::size_t i = 0; i < entries.size() && i < ids.size(); ++i) {
        if (!m_ids.empty() && ids[i] <= m_ids.back()) continue;
        m_ids.push_back(ids[i]);
        m_entries.push_back(entries[i]);
    }
    listFrom(before);
}

void IndexedFile::listFrom(std::size_t first) {
    for (std::size_t number = first; number < m_entries.size(); ++number)
        m_ofTopic[m_entries[number].topic].push_back(static_cast<std::uint32_t>(number));
    for (auto& [id, topic] : m_facts.topics) {
        const auto numbers = m_ofTopic.find(id);
        topic.messages = numbers == m_ofTopic.end() ? 0 : numbers->second.size();
    }
    if (m_entries.empty()) return;
    m_facts.firstId = idOf(0);
    m_facts.lastId = idOf(m_entries.size() - 1);
    m_facts.first = m_entries.front().received;
    m_facts.last = m_entries.back().received;
}

std::uint64_t IndexedFile::idOf(std::size_t number) const {
    return m_ids.empty() ? number + 1 : m_ids[number];
}

std::size_t IndexedFile::countUpTo(std::uint64_t id) const {
    if (m_ids.empty()) return static_cast<std::size_t>(std::min<std::uint64_t>(id, m_entries.size()));
    return static_cast<std::size_t>(std::upper_bound(m_ids.begin(), m_ids.end(), id) - m_ids.begin());
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
                                idOf(number)));
        return std::nullopt;
    }
    return BagRow{idOf(number), entry.topic, entry.received, std::move(*payload)};
}

BagFile::Outcome IndexedFile::fetch(const RowQuery& query, std::vector<BagRow>& rows) {
    lookAgain();
    std::size_t number = countUpTo(query.afterId);
    if (!m_facts.ours) {
        const auto first =
            std::lower_bound(m_entries.begin(), m_entries.end(), query.afterTime,
                             [](const IndexEntry& entry, Time time) { return entry.received < time; });
        number = std::max(number, static_cast<std::size_t>(first - m_entries.begin()));
    }
    const std::size_t end = countUpTo(query.lastId);
    std::size_t bytes = 0, taken = 0;
    for (; number < end; ++number) {
        const IndexEntry& entry = m_entries[number];
        if (entry.received > query.lastTime) {
            if (!m_facts.ours) return Outcome::End;
            continue;
        }
        if (query.topics && !query.topics->contains(entry.topic)) continue;
        auto row = rowAt(number);
        if (!row) continue;
        bytes += row->cdr->size();
        rows.push_back(std::move(*row));
        if (++taken >= FetchRows || bytes >= FetchBytes) return Outcome::More;
    }
    return Outcome::End;
}

std::optional<BagRow> IndexedFile::row(std::uint64_t id, bool& /*broken*/) {
    lookAgain();
    const std::size_t count = countUpTo(id);
    return count == 0 || idOf(count - 1) != id ? std::nullopt : rowAt(count - 1);
}

std::optional<BagRow> IndexedFile::lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
                                            bool& /*broken*/) {
    lookAgain();
    for (std::size_t upTo = countUpTo(id); upTo > 0;) {
        std::size_t newest = 0;  // how many entries there are up to the newest of one of the topics
        for (const std::int64_t topic : topics) {
            const auto numbers = m_ofTopic.find(topic);
            if (numbers == m_ofTopic.end()) continue;
            const auto after = std::lower_bound(numbers->second.begin(), numbers->second.end(), upTo);
            if (after != numbers->second.begin())
                newest = std::max<std::size_t>(newest, *std::prev(after) + std::size_t{1});
        }
        if (newest == 0) return std::nullopt;
        if (auto row = rowAt(newest - 1)) return row;
        upTo = newest - 1;  // it cannot be read: the one before
    }
    return std::nullopt;
}

std::uint64_t IndexedFile::idAt(Time time, bool& /*broken*/) {
    lookAgain();
    auto found = m_entries.end();
    if (!m_facts.ours) {
        found = std::lower_bound(m_entries.begin(), m_entries.end(), time,
                                 [](const IndexEntry& entry, Time at) { return entry.received < at; });
    } else {  // a clock that was set back lets times fall: the earliest one from then on
        for (auto one = m_entries.begin(); one != m_entries.end(); ++one) {
            if (one->received >= time && (found == m_entries.end() || one->received < found->received))
                found = one;
        }
    }
    return found == m_entries.end() ? 0 : idOf(static_cast<std::size_t>(found - m_entries.begin()));
}

}  // namespace leitstand::detail
