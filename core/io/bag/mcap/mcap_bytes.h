#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/reading/file_window.h"

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

    /// As FileWindow::at().
    [[nodiscard]] std::span<const std::byte> at(std::uint64_t offset, std::uint64_t count) {
        return m_file.at(offset, count);
    }
    /// Reads and checks the chunk at @p place. A chunk that is cut off is returned as far as it goes, one
    /// whose checksum is wrong without any records.
    [[nodiscard]] McapRecords recordsAt(const McapChunkPlace& place);
    [[nodiscard]] std::uint64_t size() const { return m_file.size(); }
    void lookAgain() { m_file.lookAgain(); }  ///< as FileWindow::lookAgain()

private:
    explicit McapBytes(FileWindow file) : m_file(std::move(file)) {}

    FileWindow m_file;
};

}  // namespace leitstand::detail
