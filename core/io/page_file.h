#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "core/base/page_store.h"
#include "core/base/result.h"

namespace leitstand {

/// A store of pages on the disk. Its file has no name, so that it disappears with the process even after a
/// crash. Released space is used again.
class PageFile final : public PageStore {
public:
    /// Opens a store in @p folder. It needs about 60 kB of disk space per key scan. Errors name the folder.
    [[nodiscard]] static Result<std::shared_ptr<PageFile>> open(const std::filesystem::path& folder);
    ~PageFile() override;

    [[nodiscard]] std::optional<std::uint64_t> put(std::span<const std::byte> bytes) override;
    [[nodiscard]] bool read(std::uint64_t page, std::span<std::byte> into) const override;
    void release(std::uint64_t page, std::size_t bytes) override;

    [[nodiscard]] std::uint64_t size() const;  ///< size of the file [B]

private:
    explicit PageFile(int file) : m_file(file) {}
    [[nodiscard]] std::uint64_t place(std::uint64_t blocks);

    const int m_file;
    mutable std::mutex m_mutex;
    std::uint64_t m_end = 0;                        ///< end of the file [blocks]
    std::map<std::uint64_t, std::uint64_t> m_free;  ///< runs of free blocks: first block -> number of blocks
};

}  // namespace leitstand
