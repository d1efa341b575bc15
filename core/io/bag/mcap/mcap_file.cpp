#include "core/io/bag/mcap/mcap_file.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/words.h"
#include "core/io/bag/mcap/mcap_index.h"

namespace leitstand::detail {
namespace {

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
    : IndexedFile(std::move(file)), m_bytes(std::move(bytes)) {}

void McapFile::takeTopics(const McapIndex& index) {
    for (const auto& [id, channel] : index.channels)
        m_facts.topics.try_emplace(id, FileTopic{.info = infoOf(channel, index), .messages = 0});
}

void McapFile::readWhole() {
    McapIndex index = mcapIndexOf(m_bytes);
    takeTopics(index);
    if (index.ours) {
        setEntries(std::move(index.entries), std::move(index.sequences));
    } else {
        setEntries(std::move(index.entries));
    }
    m_places = std::move(index.chunks);
    m_facts.closed = index.closed;
    m_facts.expected = index.stated.value_or(0);
    for (const std::string& problem : index.problems)
        m_facts.problems.push_back(this->file().string() + ": " + problem);
}

Result<std::unique_ptr<BagFile>> McapFile::open(const std::filesystem::path& file, bool live) {
    auto bytes = McapBytes::open(file);
    if (!bytes) return bytes.error();
    std::unique_ptr<McapFile> opened(new McapFile(file, std::move(bytes).value()));
    if (live) {
        opened->m_live.emplace();
        opened->m_read = McapMagic.size();
        opened->m_facts.closed = false;
        opened->setEntries({}, {});
        opened->lookAgain();
    } else {
        opened->readWhole();
    }
    return std::unique_ptr<BagFile>(std::move(opened));
}

void McapFile::lookAgain() {
    if (!m_live) return;
    m_bytes.lookAgain();
    if (m_bytes.size() <= m_read) return;
    m_read = extendMcapIndex(m_bytes, *m_live, m_read);
    takeTopics(*m_live);
    m_places = m_live->chunks;
    addEntries(std::exchange(m_live->entries, {}), std::exchange(m_live->sequences, {}));
}

std::vector<std::byte> McapFile::unpackedChunk(std::uint32_t chunk) {
    McapRecords read = m_bytes.recordsAt(m_places[chunk]);
    if (!read.problem.empty())
        report(leitstand::fill(translate("leitstand::Error", "byte {}: {}"),
                               m_places[chunk].offset - McapRecordHead, read.problem));
    return std::move(read.bytes);
}

std::optional<Payload> McapFile::payloadAt(const IndexEntry& entry) {
    Records records;
    std::span<const std::byte> content;
    if (entry.chunk == IndexEntry::NoChunk) {
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
        }
    }
    const auto message = mcapMessage(content);
    if (!message || message->channel != entry.topic || message->data.size() > MaxMessageBytes)
        return std::nullopt;
    return std::make_shared<const std::vector<std::byte>>(message->data.begin(), message->data.end());
}

}  // namespace leitstand::detail
