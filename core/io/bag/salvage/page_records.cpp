#include "core/io/bag/salvage/page_records.h"

#include <algorithm>

#include "core/io/bag/reading/bag_file.h"
#include "core/io/bag/salvage/big_endian.h"

namespace leitstand::detail {

namespace {

constexpr std::byte TableLeaf{0x0d};

/// Reads SQLite's variable-length numbers from a record or page.
class Varints {
public:
    Varints(std::span<const std::byte> bytes, std::size_t offset) : m_bytes(bytes), m_offset(offset) {}

    std::optional<std::uint64_t> next() {
        std::uint64_t value = 0;
        for (int i = 0; i < 9; ++i) {
            if (m_offset >= m_bytes.size()) return std::nullopt;
            const auto byte = std::to_integer<std::uint64_t>(m_bytes[m_offset++]);
            if (i == 8) return (value << 8U) | byte;
            value = (value << 7U) | (byte & 0x7fU);
            if ((byte & 0x80U) == 0) return value;
        }
        return value;
    }
    std::size_t offset() const { return m_offset; }

private:
    std::span<const std::byte> m_bytes;
    std::size_t m_offset;
};

std::uint64_t contentSize(std::uint64_t type) {
    constexpr std::uint64_t Sizes[] = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0};
    return type < 10 ? Sizes[type] : type < 12 ? 0 : (type - 12) / 2;
}

/// Returns how many bytes of a record of @p size stand in its leaf page (file format, section 1.6).
std::size_t localSize(std::uint64_t size, std::size_t usable) {
    const std::size_t most = usable - 35;
    if (size <= most) return static_cast<std::size_t>(size);
    const std::size_t least = (usable - 12) * 32 / 255 - 23;
    const std::size_t fits = least + static_cast<std::size_t>((size - least) % (usable - 4));
    return fits <= most ? fits : least;
}

std::optional<PageCell> cellAt(std::span<const std::byte> page, std::size_t at, std::size_t usable,
                               std::uint64_t mostBytes) {
    Varints numbers(page, at);
    const auto size = numbers.next();
    const auto row = numbers.next();
    if (!size || !row || *size < 2 || *size > mostBytes) return std::nullopt;
    PageCell cell;
    cell.row = *row;
    cell.size = *size;
    cell.offset = numbers.offset();
    cell.local = localSize(*size, usable);
    const std::size_t tail = cell.local < cell.size ? 4 : 0;
    if (cell.offset + cell.local + tail > usable) return std::nullopt;
    cell.begin = page.subspan(cell.offset, cell.local);
    if (tail != 0) cell.overflow = bigEndian32(page.subspan(cell.offset + cell.local));
    return cell;
}

}  // namespace

void eachCell(const PageFile& file, const std::function<void(const PageCell&)>& take) {
    const std::size_t usable = file.usableSize();
    const auto mostBytes = std::min<std::uint64_t>(static_cast<std::uint64_t>(file.bytes()), MaxMessageBytes);
    file.eachPage([&](std::uint32_t number, std::span<const std::byte> page) {
        const std::size_t header = number == 1 ? 100 : 0;
        if (page[header] != TableLeaf) return;
        const std::size_t cells = bigEndian16(page.subspan(header + 3));
        if (header + 8 + 2 * cells > usable) return;
        for (std::size_t i = 0; i < cells; ++i) {
            const std::size_t at = bigEndian16(page.subspan(header + 8 + 2 * i));
            if (at < header + 8 + 2 * cells || at >= usable) continue;
            auto cell = cellAt(page, at, usable, mostBytes);
            if (!cell) continue;
            cell->page = number;
            take(*cell);
        }
    });
}

std::vector<PageColumn> columnsOf(const PageCell& cell, std::size_t most) {
    Varints numbers(cell.begin, 0);
    const auto header = numbers.next();
    if (!header || *header > cell.begin.size()) return {};
    std::vector<PageColumn> columns;
    std::uint64_t offset = *header;
    while (numbers.offset() < *header) {
        const auto type = numbers.next();
        if (!type || columns.size() == most || *type == 10 || *type == 11) return {};
        const std::uint64_t size = contentSize(*type);
        if (size > cell.size) return {};
        columns.push_back({*type, offset, size});
        offset += size;
    }
    if (numbers.offset() != *header || offset != cell.size) return {};
    return columns;
}

std::optional<std::int64_t> integerIn(std::span<const std::byte> record, const PageColumn& column) {
    if (column.type == 8) return 0;
    if (column.type == 9) return 1;
    if (column.offset + column.size > record.size() || column.size == 0) return std::nullopt;
    const auto content =
        record.subspan(static_cast<std::size_t>(column.offset), static_cast<std::size_t>(column.size));
    // Two's complement, so the sign is in the first byte.
    std::uint64_t value = (content[0] & std::byte{0x80}) != std::byte{0} ? ~0ULL : 0ULL;
    for (const std::byte byte : content) value = (value << 8U) | std::to_integer<std::uint64_t>(byte);
    return static_cast<std::int64_t>(value);
}

std::optional<std::string> textIn(std::span<const std::byte> record, const PageColumn& column) {
    if (column.offset + column.size > record.size()) return std::nullopt;
    const auto* begin = reinterpret_cast<const char*>(record.data()) + column.offset;
    return std::string(begin, static_cast<std::size_t>(column.size));
}

std::optional<std::vector<std::byte>> wholeRecord(const PageFile& file, const PageCell& cell) {
    std::vector<std::byte> page(file.pageSize());
    if (!file.read(cell.page, page)) return std::nullopt;
    const auto local = std::span(page).subspan(cell.offset, cell.local);
    std::vector<std::byte> record(local.begin(), local.end());
    std::uint32_t next = cell.overflow;
    while (record.size() < cell.size) {
        if (next == 0 || !file.read(next, page)) return std::nullopt;
        const std::size_t rest = static_cast<std::size_t>(cell.size) - record.size();
        const auto part = std::span(page).subspan(4, std::min(rest, file.usableSize() - 4));
        record.insert(record.end(), part.begin(), part.end());
        next = bigEndian32(page);
    }
    // The last page of a chain names no next page; anything else is not part of this record.
    if (next != 0) return std::nullopt;
    return record;
}

}  // namespace leitstand::detail
