#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace leitstand::detail {

// Records of an MCAP file (https://mcap.dev/spec, version 0). A record is a byte of opcode, a length of 8
// bytes, and its content; all numbers are little-endian. Fields that follow those read here are ignored, as
// the specification wants it.

inline constexpr std::string_view McapMagic("\x89MCAP0\r\n", 8);
inline constexpr std::size_t McapRecordHead = 9;  ///< opcode and length [B]

enum class McapOp : std::uint8_t {
    Header = 0x01,
    Footer = 0x02,
    Schema = 0x03,
    Channel = 0x04,
    Message = 0x05,
    Chunk = 0x06,
    MessageIndex = 0x07,
    ChunkIndex = 0x08,
    Statistics = 0x0B,
    DataEnd = 0x0F,
    Sequences = 0x80,  ///< ours: mcap_sequences.h
};

/// Reads the fields of a record one after the other. After a field that the record is too short for, all
/// others are 0 or empty, and ok() is false.
class McapFields {
public:
    explicit McapFields(std::span<const std::byte> content) : m_left(content) {}

    [[nodiscard]] std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
    [[nodiscard]] std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
    [[nodiscard]] std::uint64_t u64() { return number(8); }
    /// Reads a text behind a length of 4 bytes.
    [[nodiscard]] std::string text();
    /// Reads bytes behind a length of 4 bytes. They live as long as the record.
    [[nodiscard]] std::span<const std::byte> bytes() { return take(u32()); }
    /// Returns what is left of the record.
    [[nodiscard]] std::span<const std::byte> rest() const { return m_left; }
    [[nodiscard]] bool ok() const { return m_ok; }

private:
    [[nodiscard]] std::uint64_t number(std::size_t size);
    [[nodiscard]] std::span<const std::byte> take(std::uint64_t size);

    std::span<const std::byte> m_left;
    bool m_ok = true;
};

/// The opcode of a record and the length of its content [B].
struct McapHead {
    McapOp op{};
    std::uint64_t length = 0;
};
/// Reads the McapRecordHead bytes @p head.
[[nodiscard]] McapHead mcapHead(std::span<const std::byte> head);

struct McapSchema {
    std::uint16_t id = 0;
    std::string name, encoding, data;
};
struct McapChannel {
    std::uint16_t id = 0, schema = 0;  ///< schema 0: none
    std::string topic, encoding;
    std::map<std::string, std::string> metadata;
};
struct McapMessage {
    std::uint16_t channel = 0;
    Time logged{};
    std::span<const std::byte> data;  ///< lives as long as the record
};
/// A chunk without its records.
struct McapChunk {
    std::uint64_t size = 0;  ///< of its records, uncompressed [B]
    std::uint32_t crc = 0;   ///< of its uncompressed records; 0: not given
    std::string compression;
    std::uint64_t stored = 0;  ///< size of its records as stored [B]
    std::size_t head = 0;      ///< length of what stands before its records in the record's content [B]
};
struct McapChunkIndex {
    std::uint64_t chunk = 0, length = 0;  ///< offset and length of the chunk's record, with its head [B]
    std::uint64_t indexes = 0;            ///< length of the message indexes that follow it [B]
};
struct McapFooter {
    std::uint64_t summary = 0;  ///< offset of the summary [B]; 0: none
};

// Each returns empty when the content is too short.
[[nodiscard]] std::optional<McapSchema> mcapSchema(std::span<const std::byte> content);
[[nodiscard]] std::optional<McapChannel> mcapChannel(std::span<const std::byte> content);
[[nodiscard]] std::optional<McapMessage> mcapMessage(std::span<const std::byte> content);
[[nodiscard]] std::optional<McapChunk> mcapChunk(std::span<const std::byte> content);
[[nodiscard]] std::optional<McapChunkIndex> mcapChunkIndex(std::span<const std::byte> content);
[[nodiscard]] std::optional<McapFooter> mcapFooter(std::span<const std::byte> content);
/// Returns the number of messages that the record Statistics states.
[[nodiscard]] std::optional<std::uint64_t> mcapMessageCount(std::span<const std::byte> content);

/// Returns the moment @p nanoseconds after 1970; later than Time can hold: its largest.
[[nodiscard]] Time mcapTime(std::uint64_t nanoseconds);

}  // namespace leitstand::detail
