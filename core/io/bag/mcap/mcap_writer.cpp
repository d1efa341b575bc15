#include "core/io/bag/mcap/mcap_writer.h"

#include <algorithm>
#include <limits>

#include <zlib.h>
#include <zstd.h>

#include "core/base/words.h"
#include "core/io/bag/mcap/mcap_records.h"

namespace leitstand {
namespace {

using detail::McapOp;

constexpr std::size_t ChunkSize =
    1U << 20U;            ///< uncompressed, at least; a larger message has one of its own [B]
constexpr int Level = 1;  ///< of zstd: as fast as the disk

void add(std::string& to, std::uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) to += static_cast<char>(number >> (8 * i) & 0xFFU);
}
void add16(std::string& to, std::uint16_t number) {
    add(to, number, 2);
}
void add32(std::string& to, std::uint32_t number) {
    add(to, number, 4);
}
void add64(std::string& to, std::uint64_t number) {
    add(to, number, 8);
}
void addText(std::string& to, std::string_view text) {
    add32(to, static_cast<std::uint32_t>(text.size()));
    to += text;
}

std::string record(McapOp op, std::string_view content) {
    std::string bytes(1, static_cast<char>(op));
    add64(bytes, content.size());
    bytes += content;
    return bytes;
}

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

void McapWriter::Span::add(std::uint64_t time) {
    first = std::min(first, time);
    last = std::max(last, time);
}

Result<McapWriter> McapWriter::create(const std::filesystem::path& file) {
    auto opened = detail::OutputFile::create(file);
    if (!opened) return opened.error();
    McapWriter writer(std::move(opened).value());
    std::string header;
    addText(header, "ros2");
    addText(header, "leitstand");
    writer.put(detail::McapMagic);
    writer.put(record(McapOp::Header, header));
    return writer;
}

void McapWriter::put(std::string_view bytes) {
    m_file.write(bytes);
    m_written += bytes.size();
}

std::uint16_t McapWriter::channelOf(const TopicInfo& topic) {
    const auto [known, fresh] = m_channelOf.try_emplace({topic.name, topic.type}, std::uint16_t{0});
    if (!fresh) return known->second;
    if (m_channelOf.size() > std::numeric_limits<std::uint16_t>::max()) m_tooMany = true;
    known->second = static_cast<std::uint16_t>(m_channelOf.size());
    const auto [schema, unseen] = m_schemaOf.try_emplace(topic.type, std::uint16_t{0});
    std::string described;
    if (unseen) {
        schema->second = static_cast<std::uint16_t>(m_schemaOf.size());
        std::string content;
        add16(content, schema->second);
        addText(content, topic.type);
        addText(content, topic.definition.empty() ? "" : "ros2msg");
        addText(content, topic.definition);
        described += record(McapOp::Schema, content);
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
    described += record(McapOp::Channel, content);
    m_records += described;
    m_described += described;
    return known->second;
}

void McapWriter::write(const TopicInfo& topic, const RawEvent& event) {
    const std::uint16_t channel = channelOf(topic);
    const std::uint64_t time = nanosecondsOf(event.received);
    add64(m_index[channel], time);
    add64(m_index[channel], m_records.size());
    std::string head;
    add16(head, channel);
    add32(head, static_cast<std::uint32_t>(m_counts[channel]++));
    add64(head, time);
    add64(head, time);
    m_records += static_cast<char>(McapOp::Message);
    add64(m_records, head.size() + event.cdr->size());
    m_records += head;
    m_records.append(reinterpret_cast<const char*>(event.cdr->data()), event.cdr->size());
    m_chunkTimes.add(time);
    if (m_records.size() >= ChunkSize) endChunk();
}

void McapWriter::endChunk() {
    if (m_records.empty()) return;
    if (m_index.empty()) m_chunkTimes = {0, 0};
    const std::string stored = compressed(m_records);
    Chunk chunk;
    chunk.offset = m_written;
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
    put(record(McapOp::Chunk, content));
    chunk.length = m_written - chunk.offset;
    for (const auto& [channel, entries] : m_index) {
        chunk.indexes[channel] = m_written;
        std::string index;
        add16(index, channel);
        addText(index, entries);
        put(record(McapOp::MessageIndex, index));
    }
    chunk.indexLength = m_written - chunk.offset - chunk.length;
    if (!m_index.empty()) {
        m_times.add(m_chunkTimes.first);
        m_times.add(m_chunkTimes.last);
    }
    m_chunks.push_back(std::move(chunk));
    m_records.clear();
    m_index.clear();
    m_chunkTimes = {};
}

Result<void> McapWriter::close() {
    endChunk();
    std::string end;
    add32(end, 0);  // no checksum of the data section
    put(record(McapOp::DataEnd, end));
    const std::uint64_t summary = m_written;
    std::string records = m_described;
    std::string statistics, counts;
    std::uint64_t messages = 0;
    for (const auto& [channel, count] : m_counts) {
        messages += count;
        add16(counts, channel);
        add64(counts, count);
    }
    add64(statistics, messages);
    add16(statistics, static_cast<std::uint16_t>(m_schemaOf.size()));
    add32(statistics, static_cast<std::uint32_t>(m_channelOf.size()));
    add32(statistics, 0);  // attachments
    add32(statistics, 0);  // metadata
    add32(statistics, static_cast<std::uint32_t>(m_chunks.size()));
    add64(statistics, messages > 0 ? m_times.first : 0);
    add64(statistics, m_times.last);
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
        records += record(McapOp::ChunkIndex, content);
    }
    records += record(McapOp::Statistics, statistics);
    std::string footer(1, static_cast<char>(McapOp::Footer));
    add64(footer, 20);
    add64(footer, summary);
    add64(footer, 0);  // no offsets of the summary's groups
    add32(footer, crcOf(footer, crcOf(records)));
    put(records);
    put(footer);
    put(detail::McapMagic);
    if (m_tooMany)
        return Error{leitstand::fill(translate("leitstand::Error", "expected at most {} topics"),
                                     std::numeric_limits<std::uint16_t>::max())};
    return m_file.commit();
}

}  // namespace leitstand
