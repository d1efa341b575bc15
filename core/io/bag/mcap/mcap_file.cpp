#include "core/io/bag/mcap/mcap_file.h"

#include <algorithm>
#include <iterator>

#include "core/base/words.h"

namespace leitstand::detail {
namespace {

constexpr std::size_t MostKept = 96U << 20U;  ///< of uncompressed chunks [B]; the newest is always kept

TopicInfo infoOf(const McapChannel& channel, const McapIndex& index) {
    TopicInfo info;
    info.name = channel.topic;
    info.serialization = channel.encoding;
    const auto stated = [&](const char* key) {
        const auto found = channel.metadata.find(key);
        return found == channel.metadata.end() ? std::string() : found->second;
    };
    info.qosProfiles = stated("offered_qos_profiles");
    info.typeHash = stated("topic_type_hash");
    const auto schema = index.schemas.find(channel.schema);
    if (schema == index.schemas.end()) return info;
    info.type = schema->second.name;
    if (schema->second.encoding == "ros2msg") info.definition = schema->second.data;
    return info;
}

}  // namespace

McapFile::McapFile(std::filesystem::path file, McapBytes bytes)
    : m_file(std::move(file)), m_bytes(std::move(bytes)), m_index(mcapIndexOf(m_bytes)) {
    setFacts();
}

Result<std::unique_ptr<BagFile>> McapFile::open(const std::filesystem::path& file) {
    auto bytes = McapBytes::open(file);
    if (!bytes) return bytes.error();
    return std::unique_ptr<BagFile>(new McapFile(file, std::move(bytes).value()));
}

void McapFile::setFacts() {
    for (const auto& [id, channel] : m_index.channels)
        m_facts.topics[id] = {.info = infoOf(channel, m_index), .messages = 0};
    for (std::size_t number = 0; number < m_index.entries.size(); ++number)
        m_ofTopic[m_index.entries[number].channel].push_back(static_cast<std::uint32_t>(number));
    for (auto& [id, topic] : m_facts.topics) {
        const auto numbers = m_ofTopic.find(id);
        topic.messages = numbers == m_ofTopic.end() ? 0 : numbers->second.size();
    }
    if (!m_index.entries.empty()) {
        m_facts.firstId = 1;
        m_facts.lastId = m_index.entries.size();
        m_facts.first = m_index.entries.front().logged;
        m_facts.last = m_index.entries.back().logged;
    }
    m_facts.idsByTime = true;
    m_facts.closed = m_index.closed;
    m_facts.expected = m_index.stated.value_or(0);
    for (const std::string& problem : m_index.problems)
        m_facts.problems.push_back(m_file.string() + ": " + problem);
}

void McapFile::report(const std::string& what) {
    std::string text = m_file.string() + ": " + what;
    if (m_reported.insert(text).second) m_new.push_back(std::move(text));
}

std::vector<std::string> McapFile::newProblems() {
    return std::exchange(m_new, {});
}

McapFile::Records McapFile::recordsOf(std::uint32_t chunk) {
    const auto known =
        std::find_if(m_chunks.begin(), m_chunks.end(), [&](const auto& one) { return one.first == chunk; });
    if (known != m_chunks.end()) {
        m_chunks.splice(m_chunks.begin(), m_chunks, known);
        return m_chunks.front().second;
    }
    McapRecords read = m_bytes.recordsAt(m_index.chunks[chunk]);
    if (!read.problem.empty())
        report(leitstand::fill(translate("leitstand::Error", "byte {}: {}"),
                               m_index.chunks[chunk].offset - McapRecordHead, read.problem));
    m_chunks.emplace_front(chunk, std::make_shared<const std::vector<std::byte>>(std::move(read.bytes)));
    std::size_t kept = 0;
    for (auto one = m_chunks.begin(); one != m_chunks.end();) {
        kept += one->second->size();
        one = kept > MostKept && one != m_chunks.begin() ? m_chunks.erase(one) : std::next(one);
    }
    return m_chunks.front().second;
}

std::optional<BagRow> McapFile::rowAt(std::size_t number) {
    const McapEntry& entry = m_index.entries[number];
    Records records;
    std::span<const std::byte> content;
    if (entry.chunk == McapEntry::NoChunk) {
        const auto head = m_bytes.at(entry.offset, McapRecordHead);
        if (head.size() == McapRecordHead) {
            const std::uint64_t length = mcapHead(head).length;
            content = m_bytes.at(entry.offset + McapRecordHead, std::min(length, MaxMessageBytes));
            if (content.size() < length) content = {};
        }
    } else {
        records = recordsOf(entry.chunk);
        const std::span<const std::byte> all = *records;
        if (entry.offset <= all.size() && all.size() - entry.offset >= McapRecordHead) {
            const auto from = static_cast<std::size_t>(entry.offset);
            const McapHead head = mcapHead(all.subspan(from, McapRecordHead));
            const bool whole =
                head.op == McapOp::Message && head.length <= all.size() - from - McapRecordHead;
            if (whole) content = all.subspan(from + McapRecordHead, static_cast<std::size_t>(head.length));
        } else if (all.empty()) {
            return std::nullopt;  // the chunk's own problem says why
        }
    }
    const auto message = mcapMessage(content);
    if (!message || message->channel != entry.channel || message->data.size() > MaxMessageBytes) {
        report(leitstand::fill(
            translate("leitstand::Error", "message {}: expected a message where the index says, found none"),
            number + 1));
        return std::nullopt;
    }
    return BagRow{number + 1, entry.channel, entry.logged,
                  std::make_shared<const std::vector<std::byte>>(message->data.begin(), message->data.end())};
}

BagFile::Outcome McapFile::fetch(const RowQuery& query, std::vector<BagRow>& rows) {
    const auto& entries = m_index.entries;
    const auto first =
        std::lower_bound(entries.begin(), entries.end(), query.afterTime,
                         [](const McapEntry& entry, Time time) { return entry.logged < time; });
    std::uint64_t number = std::max(static_cast<std::uint64_t>(first - entries.begin()), query.afterId);
    std::size_t bytes = 0, taken = 0;
    for (; number < entries.size() && number < query.lastId; ++number) {
        const McapEntry& entry = entries[number];
        if (entry.logged > query.lastTime) return Outcome::End;
        if (query.topics && !query.topics->contains(entry.channel)) continue;
        auto row = rowAt(static_cast<std::size_t>(number));
        if (!row) continue;
        bytes += row->cdr->size();
        rows.push_back(std::move(*row));
        if (++taken >= FetchRows || bytes >= FetchBytes) return Outcome::More;
    }
    return Outcome::End;
}

std::optional<BagRow> McapFile::row(std::uint64_t id, bool& /*broken*/) {
    return id == 0 || id > m_index.entries.size() ? std::nullopt : rowAt(static_cast<std::size_t>(id - 1));
}

std::optional<BagRow> McapFile::lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
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

std::uint64_t McapFile::idAt(Time time, bool& /*broken*/) {
    const auto& entries = m_index.entries;
    const auto found = std::lower_bound(entries.begin(), entries.end(), time,
                                        [](const McapEntry& entry, Time at) { return entry.logged < at; });
    return found == entries.end() ? 0 : static_cast<std::uint64_t>(found - entries.begin()) + 1;
}

}  // namespace leitstand::detail
