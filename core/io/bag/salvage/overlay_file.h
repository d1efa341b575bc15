#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <vector>

namespace leitstand::detail {

/// The content of a file on the disk, with later writes kept only in memory.
class OverlayFile {
public:
    OverlayFile() = default;  ///< a file that does not exist
    explicit OverlayFile(const std::filesystem::path& file);
    ~OverlayFile();
    OverlayFile(const OverlayFile&) = delete;
    OverlayFile& operator=(const OverlayFile&) = delete;

    [[nodiscard]] bool exists() const { return m_exists; }
    [[nodiscard]] std::int64_t size() const { return m_size; }
    /// Reads from @p offset; false when the disk fails. Bytes after the end are zero.
    [[nodiscard]] bool read(std::int64_t offset, std::span<std::byte> into) const;
    void write(std::int64_t offset, std::span<const std::byte> bytes);
    void resize(std::int64_t size);
    void create() { m_exists = true; }
    void remove();

private:
    using Block = std::vector<std::byte>;
    static constexpr std::int64_t BlockSize = 4'096;
    [[nodiscard]] bool readBase(std::int64_t offset, std::span<std::byte> into) const;

    int m_descriptor = -1;
    bool m_exists = false;
    std::int64_t m_baseSize = 0;  // bytes of the file on disk that still count
    std::int64_t m_size = 0;
    std::map<std::int64_t, Block> m_blocks;  // written blocks
};

}  // namespace leitstand::detail
