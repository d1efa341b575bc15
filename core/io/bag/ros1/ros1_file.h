#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/reading/file_window.h"
#include "core/io/bag/reading/indexed_file.h"
#include "core/io/bag/ros1/message_layout.h"

namespace leitstand::detail {

/// A bag of ROS 1 in format 2.0 (https://wiki.ros.org/Bags/Format/2.0): chunks as they are, by bz2 or by lz4.
/// Its messages become those of ROS 2 (Ros1Layout). One that is cut off, or was never indexed, is read as far
/// as it goes.
class Ros1File final : public IndexedFile {
public:
    /// Opens @p file. Error when it cannot be read or is no bag of ROS 1; damage within it is in the facts'
    /// problems.
    [[nodiscard]] static Result<std::unique_ptr<BagFile>> open(const std::filesystem::path& file);

private:
    /// The values of a record's head, by name.
    using Values = std::map<std::string, std::string, std::less<>>;
    struct Record {
        Values values;
        int op = -1;                         ///< -1: there is no record there
        std::uint64_t data = 0, length = 0;  ///< place and length of its data [B]
        [[nodiscard]] std::uint64_t end() const { return data + length; }
    };
    struct Chunk {
        std::uint64_t at = 0;                ///< offset of its record in the file [B]
        std::uint64_t data = 0, length = 0;  ///< of what is packed [B]
        std::string compression;
        std::uint64_t size = 0;  ///< unpacked [B]
    };
    Ros1File(std::filesystem::path file, FileWindow window)
        : IndexedFile(std::move(file)), m_window(std::move(window)) {}

    void index();
    /// Returns the record at @p offset of the file. Its data may reach beyond the end of the file.
    [[nodiscard]] Record recordAt(std::uint64_t offset);
    void addConnection(const Values& values, std::span<const std::byte> data);
    /// Adds what an index record says of chunk @p chunk.
    void addIndex(const Record& record, std::uint32_t chunk, std::vector<IndexEntry>& entries);
    /// Reads the connections, and with @p entries the messages, of chunk @p chunk.
    void scan(std::uint32_t chunk, std::vector<IndexEntry>* entries);
    void problem(std::uint64_t at, const std::string& what);
    [[nodiscard]] std::optional<Payload> payloadAt(const IndexEntry& entry) override;
    [[nodiscard]] std::vector<std::byte> unpackedChunk(std::uint32_t chunk) override;

    FileWindow m_window;
    std::vector<Chunk> m_chunks;
    std::map<std::uint32_t, Ros1Layout> m_layouts;  ///< by connection
};

}  // namespace leitstand::detail
