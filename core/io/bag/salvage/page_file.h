#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "core/io/bag/salvage/overlay_file.h"

namespace leitstand::detail {

/// The pages of an SQLite file as raw bytes, those that its write-ahead log commits in place of the file's.
/// For files that SQLite itself cannot read (https://www.sqlite.org/fileformat2.html).
class PageFile {
public:
    /// @p pageSize: as taken from the file's header when that can be read, else a guess.
    PageFile(const std::filesystem::path& file, std::size_t pageSize);

    /// The page size that the header of @p file tells; 0 when there is none.
    [[nodiscard]] static std::size_t toldPageSize(const std::filesystem::path& file);

    [[nodiscard]] std::size_t pageSize() const { return m_pageSize; }
    /// Bytes of a page that hold content.
    [[nodiscard]] std::size_t usableSize() const { return m_pageSize - m_reserved; }
    /// Calls @p take with number and content of every page.
    void eachPage(const std::function<void(std::uint32_t, std::span<const std::byte>)>& take) const;
    /// Of the file and its log [B].
    [[nodiscard]] std::int64_t bytes() const { return m_file.size() + m_log.size(); }
    /// Reads the beginning of page @p number, from 1; false when there is none. @p into has at most
    /// pageSize() bytes.
    [[nodiscard]] bool read(std::uint32_t number, std::span<std::byte> into) const;
    /// Whether the chain of overflow pages that begins with @p first is there and ends after @p size bytes.
    [[nodiscard]] bool isWhole(std::uint32_t first, std::uint64_t size) const;

private:
    OverlayFile m_file, m_log;
    std::size_t m_pageSize, m_reserved = 0;
    std::uint32_t m_pages = 0;
    std::map<std::uint32_t, std::int64_t> m_logged;  // page -> offset of its newest content in the log
};

}  // namespace leitstand::detail
