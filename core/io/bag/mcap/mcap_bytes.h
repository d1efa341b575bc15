#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/detail/input_file.h"

namespace leitstand::detail {

/// Where a chunk is in its file.
struct McapChunkPlace {
    std::uint64_t offset = 0, length = 0;  ///< of the content of its record [B]
};

/// The records of a chunk, uncompressed.
struct McapRecords {
    std::vector<std::byte> bytes;  ///< as far as they can be read
    std::string problem;           ///< in words, without the file's name; empty: they are whole
};

/// The bytes of an MCAP file. One thread.
class McapBytes {
public:
    /// Opens @p path. Error when it cannot be read, or does not begin as MCAP does.
    [[nodiscard]] static Result<McapBytes> open(const std::filesystem::path& path);

    /// Returns @p count bytes from byte @p offset, or fewer at the end of the file or where the disk fails.
    /// They stay valid until the next call.
    [[nodiscard]] std::span<const std::byte> at(std::uint64_t offset, std::uint64_t count);
    /// Reads and checks the chunk at @p place. A chunk that is cut off is returned as far as it goes, one
    /// whose checksum is wrong without any records.
    [[nodiscard]] McapRecords recordsAt(const McapChunkPlace& place);
    [[nodiscard]] std::uint64_t size() const { return m_file.size(); }

private:
    explicit McapBytes(InputFile file) : m_file(std::move(file)) {}

    InputFile m_file;
    std::uint64_t m_begin = 0;        ///< of m_window in the file [B]
    std::vector<std::byte> m_window;  ///< what was read last
};

}  // namespace leitstand::detail
