#include "core/io/bag/mcap/mcap_bytes.h"

#include <algorithm>
#include <utility>

#include <zlib.h>

#include "core/base/words.h"
#include "core/io/bag/mcap/decompression.h"
#include "core/io/bag/mcap/mcap_records.h"
#include "core/io/bag/reading/bag_file.h"

namespace leitstand::detail {
namespace {

constexpr std::uint64_t Ahead = 1U << 20U;  ///< is read at once, where records are small [B]
/// Largest chunk, uncompressed [B]: room for the largest message and its neighbours.
constexpr std::uint64_t MostRecords = MaxMessageBytes + (64U << 20U);

std::uint32_t crcOf(std::span<const std::byte> bytes) {
    uLong crc = crc32_z(0, nullptr, 0);
    return static_cast<std::uint32_t>(
        crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

Result<McapBytes> McapBytes::open(const std::filesystem::path& path) {
    auto file = InputFile::open(path);
    if (!file) return file.error();
    McapBytes bytes(std::move(file).value());
    const auto begin = bytes.at(0, McapMagic.size());
    const std::string_view found(reinterpret_cast<const char*>(begin.data()), begin.size());
    if (found != McapMagic)
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: byte 0: expected the beginning of an MCAP file"),
            path.string())};
    return bytes;
}

std::span<const std::byte> McapBytes::at(std::uint64_t offset, std::uint64_t count) {
    if (offset >= m_file.size()) return {};
    count = std::min(count, m_file.size() - offset);
    const bool here = offset >= m_begin && offset + count <= m_begin + m_window.size();
    if (!here) {
        const std::uint64_t wanted = std::min(std::max(count, Ahead), m_file.size() - offset);
        m_window.resize(static_cast<std::size_t>(wanted));
        m_begin = offset;
        std::size_t got = 0;
        if (m_file.seek(offset)) {
            const auto read = m_file.read(reinterpret_cast<char*>(m_window.data()), m_window.size());
            got = read ? *read : 0;
        }
        m_window.resize(got);
    }
    const auto from = static_cast<std::size_t>(offset - m_begin);
    if (from >= m_window.size()) return {};
    return std::span(std::as_const(m_window))
        .subspan(from, std::min<std::size_t>(count, m_window.size() - from));
}

McapRecords McapBytes::recordsAt(const McapChunkPlace& place) {
    const std::span<const std::byte> content = at(place.offset, place.length);
    const auto chunk = mcapChunk(content);
    if (!chunk)
        return {{}, translate("leitstand::Error", "expected a chunk, found one that is cut off or broken")};
    const auto stored = content.subspan(chunk->head);
    const bool cut = stored.size() < chunk->stored;
    const auto records = decompressed(
        stored.first(static_cast<std::size_t>(std::min<std::uint64_t>(stored.size(), chunk->stored))),
        chunk->compression, std::min(chunk->size, MostRecords) + 1);
    if (!records)
        return {{},
                leitstand::fill(
                    translate("leitstand::Error", "expected a chunk compressed by zstd or lz4, found \"{}\""),
                    chunk->compression.substr(0, 40))};
    if (cut)
        return {records->bytes, translate("leitstand::Error", "the chunk is cut off; its beginning is read")};
    if (!records->whole || records->bytes.size() != chunk->size)
        return {{},
                leitstand::fill(translate("leitstand::Error",
                                          "expected a chunk of {} bytes, found {} that can be decompressed"),
                                chunk->size, records->bytes.size())};
    if (chunk->crc != 0 && crcOf(records->bytes) != chunk->crc)
        return {{}, translate("leitstand::Error", "the chunk is damaged: its checksum is wrong")};
    return {records->bytes, {}};
}

}  // namespace leitstand::detail
