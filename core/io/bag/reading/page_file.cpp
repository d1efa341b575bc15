#include "core/io/bag/reading/page_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>

namespace leitstand::detail {

namespace {

constexpr std::string_view Magic("SQLite format 3\0", 16);
constexpr std::int64_t LogHeader = 32, FrameHeader = 24;

bool plausiblePageSize(std::size_t size) {
    return size >= 512 && size <= 65'536 && std::has_single_bit(size);
}

/// The checksum of a write-ahead log, over 32-bit words in the byte order that its header names.
struct LogChecksum {
    std::uint32_t a = 0, b = 0;
    bool big = false;

    void add(std::span<const std::byte> bytes) {
        for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
            a += word(bytes.subspan(i)) + b;
            b += word(bytes.subspan(i + 4)) + a;
        }
    }
    std::uint32_t word(std::span<const std::byte> bytes) const {
        const std::uint32_t value = bigEndian32(bytes);
        return big ? value : __builtin_bswap32(value);
    }
};

}  // namespace

std::uint32_t bigEndian16(std::span<const std::byte> bytes) {
    return (std::to_integer<std::uint32_t>(bytes[0]) << 8U) | std::to_integer<std::uint32_t>(bytes[1]);
}

std::uint32_t bigEndian32(std::span<const std::byte> bytes) {
    return (bigEndian16(bytes) << 16U) | bigEndian16(bytes.subspan(2));
}

std::size_t PageFile::toldPageSize(const std::filesystem::path& file) {
    const OverlayFile content(file);
    std::array<std::byte, 100> header{};
    if (content.size() < std::ssize(header) || !content.read(0, header)) return 0;
    if (std::memcmp(header.data(), Magic.data(), Magic.size()) != 0) return 0;
    const std::uint32_t told = bigEndian16(std::span(header).subspan(16));
    const std::size_t size = told == 1 ? 65'536 : told;
    return plausiblePageSize(size) ? size : 0;
}

PageFile::PageFile(const std::filesystem::path& file, std::size_t pageSize)
    : m_file(file), m_log(file.string() + "-wal"), m_pageSize(pageSize) {
    std::array<std::byte, 100> header{};
    if (toldPageSize(file) == pageSize && m_file.read(0, header)) {
        const auto reserved = std::to_integer<std::size_t>(header[20]);
        if (pageSize - reserved >= 480) m_reserved = reserved;
    }
    const auto whole = m_file.size() / static_cast<std::int64_t>(m_pageSize);
    m_pages = static_cast<std::uint32_t>(
        std::min<std::int64_t>(whole, std::numeric_limits<std::uint32_t>::max() - 1));
    readLog();
}

void PageFile::readLog() {
    std::array<std::byte, LogHeader> header{};
    if (m_log.size() < LogHeader || !m_log.read(0, header)) return;
    const std::span<const std::byte> fields(header);
    const std::uint32_t magic = bigEndian32(fields);
    if ((magic & ~1U) != 0x377f0682U || bigEndian32(fields.subspan(8)) % 65'536 != m_pageSize % 65'536)
        return;
    LogChecksum sum{.big = (magic & 1U) != 0};
    sum.add(fields.first(24));
    if (sum.a != bigEndian32(fields.subspan(24)) || sum.b != bigEndian32(fields.subspan(28))) return;

    std::vector<std::byte> frame(static_cast<std::size_t>(FrameHeader) + m_pageSize);
    std::map<std::uint32_t, std::int64_t> pending;  // of a transaction that is not committed yet
    for (std::int64_t at = LogHeader; at + std::ssize(frame) <= m_log.size(); at += std::ssize(frame)) {
        if (!m_log.read(at, frame)) return;
        const std::span<const std::byte> bytes(frame);
        // Frames of an earlier round of the log have other salts, torn ones another sum.
        if (!std::equal(bytes.begin() + 8, bytes.begin() + 16, fields.begin() + 16)) return;
        sum.add(bytes.first(8));
        sum.add(bytes.subspan(FrameHeader));
        if (sum.a != bigEndian32(bytes.subspan(16)) || sum.b != bigEndian32(bytes.subspan(20))) return;
        const std::uint32_t page = bigEndian32(bytes);
        if (page == 0) return;
        pending[page] = at + FrameHeader;
        if (bigEndian32(bytes.subspan(4)) == 0) continue;
        for (const auto& [number, offset] : pending) m_logged[number] = offset;
        pending.clear();
    }
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
