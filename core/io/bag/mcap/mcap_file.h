#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/mcap/mcap_bytes.h"
#include "core/io/bag/mcap/mcap_index.h"
#include "core/io/bag/reading/indexed_file.h"

namespace leitstand::detail {

/// An MCAP file of rosbag2 or another recorder: with an index or without, compressed or not, and cut off
/// where its writer was killed.
class McapFile final : public IndexedFile {
public:
    /// Opens @p file. Error when it cannot be read or is no MCAP file; damage within it is in the facts'
    /// problems.
    /// @p live: a mission's writer has the file open. Then each query looks for what was added.
    [[nodiscard]] static Result<std::unique_ptr<BagFile>> open(const std::filesystem::path& file,
                                                               bool live = false);

private:
    McapFile(std::filesystem::path file, McapBytes bytes);
    void readWhole();
    void takeTopics(const McapIndex& index);
    void lookAgain() override;
    [[nodiscard]] std::optional<Payload> payloadAt(const IndexEntry& entry) override;
    [[nodiscard]] std::vector<std::byte> unpackedChunk(std::uint32_t chunk) override;

    McapBytes m_bytes;
    std::optional<McapIndex> m_live;  ///< of a file that is written: what it describes, without its entries
    std::uint64_t m_read = 0;         ///< up to where that file was read [B]
    std::vector<McapChunkPlace> m_places;  ///< of chunks
};

}  // namespace leitstand::detail
