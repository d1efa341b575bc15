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

/// The pages of an SQLite file as raw bytes. Pages that are committed in its write-ahead log replace those of
/// the file. For files that SQLite itself cannot read (https://www.sqlite.org/fileformat2.html).
class PageFile {
public:
    /// @p pageSize [B] is taken from the header of the file if that can be read; otherwise it is a guess.
    PageFile(const std::filesystem::path& file, std::size_t pageSize);

    /// Returns the page size in the header of @p file [B]; 0 when there is none.
    [[nodiscard]] static std::size_t pageSizeOf(const std::filesystem::path& file);

    [[nodiscard]] std::size_t pageSize() const { return m_pageSize; }
    /// Number of bytes of a page that hold content.
    [[nodiscard]] std::size_t usableSize() const { return m_pageSize - m_reserved; }
    /// Calls @p take with the number and content of every page.
    void eachPage(const std::function<void(std::uint32_t, std::span<const std::byte>)>& take) const;
    /// Size of the file and its log together [B].
    [[nodiscard]] std::int64_t bytes() const { return m_file.size() + m_log.size(); }
    /// Reads the beginning of page @p number, counted from 1; false when there is none. @p into has at most
    /// pageSize() bytes.
    [[nodiscard]] bool read(std::uint32_t number, std::span<std::byte> into) const;
    /// Whether the chain of overflow pages that begins with @p first is complete and ends after @p size
    /// bytes.
    [[nodiscard]] bool isWhole(std::uint32_t first, std::uint64_t size) const;

private:
    OverlayFile m_file, m_log;
    std::size_t m_pageSize, m_reserved = 0;
    std::uint32_t m_pages = 0;
    std::map<std::uint32_t, std::int64_t> m_logged;  // page -> offset of its newest content in the log
};

}  // namespace leitstand::detail
