#include "core/io/bag/salvage/page_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>

#include "core/io/bag/salvage/big_endian.h"
#include "core/io/bag/salvage/log_frames.h"

namespace leitstand::detail {

namespace {

constexpr std::string_view Magic("SQLite format 3\0", 16);

bool plausiblePageSize(std::size_t size) {
    return size >= 512 && size <= 65'536 && std::has_single_bit(size);
}

}  // namespace

std::size_t PageFile::pageSizeOf(const std::filesystem::path& file) {
    const OverlayFile content(file);
    std::array<std::byte, 100> header{};
    if (content.size() < std::ssize(header) || !content.read(0, header)) return 0;
    if (std::memcmp(header.data(), Magic.data(), Magic.size()) != 0) return 0;
    const std::uint32_t stated = bigEndian16(std::span(header).subspan(16));
    const std::size_t size = stated == 1 ? 65'536 : stated;
    return plausiblePageSize(size) ? size : 0;
}

PageFile::PageFile(const std::filesystem::path& file, std::size_t pageSize)
    : m_file(file), m_log(file.string() + "-wal"), m_pageSize(pageSize) {
    std::array<std::byte, 100> header{};
    if (pageSizeOf(file) == pageSize && m_file.read(0, header)) {
        const auto reserved = std::to_integer<std::size_t>(header[20]);
        if (pageSize - reserved >= 480) m_reserved = reserved;
    }
    const auto whole = m_file.size() / static_cast<std::int64_t>(m_pageSize);
    m_pages = static_cast<std::uint32_t>(
        std::min<std::int64_t>(whole, std::numeric_limits<std::uint32_t>::max() - 1));
    m_logged = logFrames(m_log, m_pageSize).pages;
}

bool PageFile::isWhole(std::uint32_t first, std::uint64_t size) const {
    const std::size_t content = usableSize() - 4;
    std::uint32_t page = first;
    std::array<std::byte, 4> next{};
    for (std::uint64_t rest = size; rest > 0; rest -= std::min<std::uint64_t>(rest, content)) {
        if (page == 0 || !read(page, next)) return false;
        page = bigEndian32(next);
    }
    return page == 0;
}

bool PageFile::read(std::uint32_t number, std::span<std::byte> into) const {
    const auto logged = m_logged.find(number);
    if (logged != m_logged.end()) return m_log.read(logged->second, into);
    if (number == 0 || number > m_pages) return false;
    const std::int64_t offset = static_cast<std::int64_t>(number - 1) * static_cast<std::int64_t>(m_pageSize);
    return offset + std::ssize(into) <= m_file.size() && m_file.read(offset, into);
}

void PageFile::eachPage(const std::function<void(std::uint32_t, std::span<const std::byte>)>& take) const {
    std::vector<std::byte> page(m_pageSize);
    const auto one = [&](std::uint32_t number) {
        if (read(number, page)) take(number, page);
    };
    for (std::uint32_t number = 1; number <= m_pages; ++number) one(number);
    for (auto beyond = m_logged.upper_bound(m_pages); beyond != m_logged.end(); ++beyond) one(beyond->first);
}

}  // namespace leitstand::detail
