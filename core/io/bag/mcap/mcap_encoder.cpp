#include "core/io/bag/mcap/mcap_encoder.h"

#include <algorithm>

#include <zlib.h>
#include <zstd.h>

#include "core/io/bag/mcap/mcap_output.h"

namespace leitstand::detail {
namespace {

constexpr std::size_t ChunkSize =
    1U << 20U;            ///< uncompressed, at least; a larger message has one of its own [B]
constexpr int Level = 1;  ///< of zstd: as fast as the disk

std::uint32_t crcOf(std::string_view bytes, std::uint32_t before = 0) {
    return static_cast<std::uint32_t>(
        crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::uint64_t nanosecondsOf(Time time) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, time.time_since_epoch().count()));
}

std::string compressed(std::string_view bytes) {
    std::string result(ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t size = ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), Level);
    result.resize(ZSTD_isError(size) != 0 ? 0 : size);
    return result;
}

}  // namespace

void McapEncoder::Span::add(std::uint64_t time) {
    first = std::min(first, time);
    last = std::max(last, time);
}

McapEncoder::McapEncoder(Sequences sequences) : m_sequences(sequences) {
    std::string header;
    addText(header, "ros2");
    addText(header, "leitstand");
    put(McapMagic);
    putRecord(McapOp::Header, header);
    if (m_sequences == Sequences::Kept) putRecord(McapOp::Sequences, McapSequences().content());
}

void McapEncoder::put(std::string_view bytes) {
    m_made += bytes;
    m_state.length += bytes.size();
}

void McapEncoder::putRecord(McapOp op, std::string_view content) {
    std::string record;
    addRecord(record, op, content);
    put(record);
}

std::uint16_t McapEncoder::channelOf(const TopicInfo& topic) {
    const auto [known, fresh] = m_state.channelOf.try_emplace({topic.name, topic.type}, std::uint16_t{0});
    if (!fresh) return known->second;
    known->second = static_cast<std::uint16_t>(m_state.channelOf.size());
    const auto [schema, unseen] = m_state.schemaOf.try_emplace(topic.type, std::uint16_t{0});
    std::string described;
    if (unseen) {
        schema->second = static_cast<std::uint16_t>(m_state.schemaOf.size());
        std::string content;
        add16(content, schema->second);
        addText(content, topic.type);
        addText(content, topic.definition.empty() ? "" : "ros2msg");
        addText(content, topic.definition);
        addRecord(described, McapOp::Schema, content);
    }
    std::string content, metadata;
    add16(content, known->second);
    add16(content, schema->second);
    addText(content, topic.name);
    addText(content, topic.serialization);
    for (const auto& [key, value] :
         {std::pair<std::string_view, std::string_view>{"offered_qos_profiles", topic.qosProfiles},
          {"topic_type_hash", topic.typeHash}}) {
        if (value.empty()) continue;
        addText(metadata, key);
        addText(metadata, value);
    }
    addText(content, metadata);
    addRecord(described, McapOp::Channel, content);
    m_records += described;
    m_described += described;
    return known->second;
}

void McapEncoder::add(const TopicInfo& topic, const RawEvent& event) {
    const std::uint16_t channel = channelOf(topic);
    const std::uint64_t time = nanosecondsOf(event.received);
    add64(m_index[channel], time);
    add64(m_index[channel], m_records.size());
    std::string head;
    add16(head, channel);
    add32(head, static_cast<std::uint32_t>(m_state.counts[channel]++));
    add64(head, time);
    add64(head, time);
    m_records += static_cast<char>(McapOp::Message);
    add64(m_records, head.size() + event.cdr->size());
    m_records += head;
    m_records.append(reinterpret_cast<const char*>(event.cdr->data()), event.cdr->size());
    m_chunkTimes.add(time);
    if (m_sequences == Sequences::Kept) m_chunkSequences.add(event.sequence);
    if (m_records.size() >= ChunkSize) endChunk();
}

void McapEncoder::endChunk() {
    if (m_records.empty()) return;
    if (m_index.empty()) m_chunkTimes = {0, 0};
    if (m_sequences == Sequences::Kept) {
        putRecord(McapOp::Sequences, m_chunkSequences.content());
        m_state.sequences.add(m_chunkSequences);
    }
    const std::string stored = compressed(m_records);
    Chunk chunk;
    chunk.offset = m_state.length;
    chunk.size = m_records.size();
    chunk.stored = stored.size();
    chunk.times = m_chunkTimes;
    std::string content;
    add64(content, m_chunkTimes.first);
    add64(content, m_chunkTimes.last);
    add64(content, m_records.size());
    add32(content, crcOf(m_records));
    addText(content, "zstd");
    add64(content, stored.size());
    content += stored;
    putRecord(McapOp::Chunk, content);
    chunk.length = m_state.length - chunk.offset;
    for (const auto& [channel, entries] : m_index) {
        chunk.indexes[channel] = m_state.length;
        std::string index;
        add16(index, channel);
        addText(index, entries);
        putRecord(McapOp::MessageIndex, index);
    }
    chunk.indexLength = m_state.length - chunk.offset - chunk.length;
    if (!m_index.empty()) {
        m_state.times.add(m_chunkTimes.first);
        m_state.times.add(m_chunkTimes.last);
    }
    m_chunks.push_back(std::move(chunk));
    m_records.clear();
    m_index.clear();
    m_chunkSequences.clear();
    m_chunkTimes = {};
}

void McapEncoder::endFile() {
    endChunk();
    std::string end;
    add32(end, 0);  // no checksum of the data section
    putRecord(McapOp::DataEnd, end);
    const std::uint64_t summary = m_state.length;
    std::string records = m_described;
    std::string statistics, counts;
    std::uint64_t messages = 0;
    for (const auto& [channel, count] : m_state.counts) {
        messages += count;
        add16(counts, channel);
        add64(counts, count);
    }
    add64(statistics, messages);
    add16(statistics, static_cast<std::uint16_t>(m_state.schemaOf.size()));
    add32(statistics, static_cast<std::uint32_t>(m_state.channelOf.size()));
    add32(statistics, 0);  // attachments
    add32(statistics, 0);  // metadata
    add32(statistics, static_cast<std::uint32_t>(m_chunks.size()));
    add64(statistics, messages > 0 ? m_state.times.first : 0);
    add64(statistics, m_state.times.last);
    addText(statistics, counts);
    for (const Chunk& chunk : m_chunks) {
        std::string content, indexes;
        for (const auto& [channel, offset] : chunk.indexes) {
            add16(indexes, channel);
            add64(indexes, offset);
        }
        add64(content, chunk.times.first);
        add64(content, chunk.times.last);
        add64(content, chunk.offset);
        add64(content, chunk.length);
        addText(content, indexes);
        add64(content, chunk.indexLength);
        addText(content, "zstd");
        add64(content, chunk.stored);
        add64(content, chunk.size);
        addRecord(records, McapOp::ChunkIndex, content);
    }
    addRecord(records, McapOp::Statistics, statistics);
    if (m_sequences == Sequences::Kept) addRecord(records, McapOp::Sequences, m_state.sequences.content());
    std::string footer(1, static_cast<char>(McapOp::Footer));
    add64(footer, 20);
    add64(footer, summary);
    add64(footer, 0);  // no offsets of the summary's groups
    add32(footer, crcOf(footer, crcOf(records)));
    put(records);
    put(footer);
    put(McapMagic);
}

McapEncoder::Mark McapEncoder::mark() const {
    Mark mark;
    mark.m_state = m_state;
    mark.m_described = m_described.size();
    mark.m_chunks = m_chunks.size();
    return mark;
}

void McapEncoder::goBackTo(const Mark& mark) {
    m_state = mark.m_state;
    m_described.resize(mark.m_described);
    m_chunks.resize(mark.m_chunks);
    m_made.clear();
    m_records.clear();
    m_index.clear();
    m_chunkSequences.clear();
    m_chunkTimes = {};
}

}  // namespace leitstand::detail
