#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/io/bag/mcap/mcap_bytes.h"
#include "core/io/bag/mcap/mcap_records.h"
#include "core/io/bag/reading/indexed_file.h"

namespace leitstand::detail {

/// What an MCAP file holds, without its messages.
struct McapIndex {
    std::map<std::uint16_t, McapSchema> schemas;
    std::map<std::uint16_t, McapChannel> channels;
    std::vector<McapChunkPlace> chunks;
    std::vector<IndexEntry> entries;       ///< in no order
    bool ours = false;                     ///< a mission's: messages have sequences
    std::vector<std::uint64_t> sequences;  ///< of the entries, in their order; empty unless ours
    std::optional<std::uint64_t> stated;   ///< number of messages by the file's statistics
    bool closed = false;                   ///< its writer finished it
    std::vector<std::string> problems;     ///< without the file's name
};

/// Reads the index of @p bytes: the summary and the message indexes behind chunks where there are any, else
/// the whole file from its beginning, as far as it goes.
[[nodiscard]] McapIndex mcapIndexOf(McapBytes& bytes);

/// Adds to @p index what a mission's writer has put behind byte @p from, which is where a record begins:
/// whole chunks, each with its sequences and its indexes. Entries are in the order of their sequences.
/// Returns up to where it was read.
[[nodiscard]] std::uint64_t extendMcapIndex(McapBytes& bytes, McapIndex& index, std::uint64_t from);

/// Calls @p take with each whole record in @p records: its opcode, its offset and its content. Returns where
/// what can be read ends.
std::size_t forEachRecord(std::span<const std::byte> records,
                          const std::function<void(McapOp, std::size_t, std::span<const std::byte>)>& take);

}  // namespace leitstand::detail
