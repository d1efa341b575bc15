#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/io/bag/mcap/mcap_bytes.h"
#include "core/io/bag/mcap/mcap_records.h"

namespace leitstand::detail {

/// Where a message is.
struct McapEntry {
    static constexpr std::uint32_t NoChunk = std::numeric_limits<std::uint32_t>::max();

    Time logged{};
    /// Of its record: in the records of its chunk, or in the file when it is in none [B].
    std::uint64_t offset = 0;
    std::uint32_t chunk = NoChunk;  ///< index into McapIndex::chunks
    std::uint16_t channel = 0;
};

/// What an MCAP file holds, without its messages.
struct McapIndex {
    std::map<std::uint16_t, McapSchema> schemas;
    std::map<std::uint16_t, McapChannel> channels;
    std::vector<McapChunkPlace> chunks;
    std::vector<McapEntry> entries;       ///< by time; those of one moment as they are in the file
    std::optional<std::uint64_t> stated;  ///< number of messages by the file's statistics
    bool closed = false;                  ///< its writer finished it
    std::vector<std::string> problems;    ///< without the file's name
};

/// Reads the index of @p bytes: the summary and the message indexes behind chunks where there are any, else
/// the whole file from its beginning, as far as it goes.
[[nodiscard]] McapIndex mcapIndexOf(McapBytes& bytes);

/// Calls @p take with each whole record in @p records: its opcode, its offset and its content. Returns where
/// what can be read ends.
std::size_t forEachRecord(std::span<const std::byte> records,
                          const std::function<void(McapOp, std::size_t, std::span<const std::byte>)>& take);

}  // namespace leitstand::detail
