#include "core/io/bag/mcap/mcap_records.h"

#include <algorithm>
#include <limits>

namespace leitstand::detail {

std::uint64_t McapFields::number(std::size_t size) {
    std::uint64_t value = 0;
    const std::span<const std::byte> bytes = take(size);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value |= std::to_integer<std::uint64_t>(bytes[i]) << (8 * i);
    return value;
}

std::span<const std::byte> McapFields::take(std::uint64_t size) {
    if (!m_ok || size > m_left.size()) {
        m_ok = false;
        return {};
    }
    const auto taken = m_left.first(static_cast<std::size_t>(size));
    m_left = m_left.subspan(static_cast<std::size_t>(size));
    return taken;
}

std::string McapFields::text() {
    const std::span<const std::byte> letters = bytes();
    return {reinterpret_cast<const char*>(letters.data()), letters.size()};
}

McapHead mcapHead(std::span<const std::byte> head) {
    McapFields fields(head.subspan(1));
    return {static_cast<McapOp>(head[0]), fields.u64()};
}

std::optional<McapSchema> mcapSchema(std::span<const std::byte> content) {
    McapFields fields(content);
    McapSchema schema;
    schema.id = fields.u16();
    schema.name = fields.text();
    schema.encoding = fields.text();
    schema.data = fields.text();
    return fields.ok() ? std::optional(std::move(schema)) : std::nullopt;
}

std::optional<McapChannel> mcapChannel(std::span<const std::byte> content) {
    McapFields fields(content);
    McapChannel channel;
    channel.id = fields.u16();
    channel.schema = fields.u16();
    channel.topic = fields.text();
    channel.encoding = fields.text();
    McapFields metadata(fields.bytes());
    while (metadata.ok() && !metadata.rest().empty()) {
        std::string key = metadata.text();
        channel.metadata[std::move(key)] = metadata.text();
    }
    return fields.ok() && metadata.ok() ? std::optional(std::move(channel)) : std::nullopt;
}

std::optional<McapMessage> mcapMessage(std::span<const std::byte> content) {
    McapFields fields(content);
    McapMessage message;
    message.channel = fields.u16();
    (void)fields.u32();  // publisher's sequence
    message.logged = mcapTime(fields.u64());
    (void)fields.u64();  // when it was published
    message.data = fields.rest();
    return fields.ok() ? std::optional(message) : std::nullopt;
}

std::optional<McapChunk> mcapChunk(std::span<const std::byte> content) {
    McapFields fields(content);
    McapChunk chunk;
    (void)fields.u64();  // times of its messages
    (void)fields.u64();
    chunk.size = fields.u64();
    chunk.crc = fields.u32();
    chunk.compression = fields.text();
    chunk.stored = fields.u64();
    chunk.head = content.size() - fields.rest().size();
    return fields.ok() ? std::optional(std::move(chunk)) : std::nullopt;
}

std::optional<McapChunkIndex> mcapChunkIndex(std::span<const std::byte> content) {
    McapFields fields(content);
    McapChunkIndex index;
    (void)fields.u64();  // times of its messages
    (void)fields.u64();
    index.chunk = fields.u64();
    index.length = fields.u64();
    (void)fields.bytes();  // where each channel's index is
    index.indexes = fields.u64();
    return fields.ok() ? std::optional(index) : std::nullopt;
}

std::optional<McapFooter> mcapFooter(std::span<const std::byte> content) {
    McapFields fields(content);
    const McapFooter footer{fields.u64()};
    return fields.ok() ? std::optional(footer) : std::nullopt;
}

std::optional<std::uint64_t> mcapMessageCount(std::span<const std::byte> content) {
    McapFields fields(content);
    const std::uint64_t count = fields.u64();
    return fields.ok() ? std::optional(count) : std::nullopt;
}

Time mcapTime(std::uint64_t nanoseconds) {
    constexpr auto Most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return Time(std::chrono::nanoseconds(static_cast<std::int64_t>(std::min(nanoseconds, Most))));
}

}  // namespace leitstand::detail
