#include "core/io/bag/mcap/mcap_bytes.h"

#include <algorithm>
#include <utility>

#include <libdeflate.h>

#include "core/base/words.h"
#include "core/io/bag/mcap/mcap_records.h"
#include "core/io/bag/reading/bag_file.h"
#include "core/io/bag/reading/decompression.h"

namespace leitstand::detail {
namespace {

/// Largest chunk, uncompressed [B]: room for the largest message and its neighbours.
constexpr std::uint64_t MostRecords = MaxMessageBytes + (64U << 20U);

std::uint32_t crcOf(std::span<const std::byte> bytes) {
    return libdeflate_crc32(0, bytes.data(), bytes.size());  // several times as fast as zlib's
}

}  // namespace

Result<McapBytes> McapBytes::open(const std::filesystem::path& path) {
    auto file = FileWindow::open(path);
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

McapRecords McapBytes::recordsAt(const McapChunkPlace& place) {
    if (place.length > MostRecords)
        return {
            {},
            leitstand::fill(translate("leitstand::Error", "expected a chunk of at most {} bytes, found {}"),
                            MostRecords, place.length)};
    const std::span<const std::byte> content = at(place.offset, place.length);
    const auto chunk = mcapChunk(content);
    if (!chunk)
        return {{}, translate("leitstand::Error", "expected a chunk, found one that is cut off or broken")};
    const auto stored = content.subspan(chunk->head);
    const bool cut = stored.size() < chunk->stored;
    const bool known =
        chunk->compression.empty() || chunk->compression == "zstd" || chunk->compression == "lz4";
    if (chunk->size > MostRecords)
        return {
            {},
            leitstand::fill(translate("leitstand::Error", "expected a chunk of at most {} bytes, found {}"),
                            MostRecords, chunk->size)};
    auto records = !known ? std::nullopt
                          : decompressed(stored.first(static_cast<std::size_t>(
                                             std::min<std::uint64_t>(stored.size(), chunk->stored))),
                                         chunk->compression, std::min(chunk->size, MostRecords) + 1);
    if (!records)
        return {{},
                leitstand::fill(
                    translate("leitstand::Error", "expected a chunk compressed by zstd or lz4, found \"{}\""),
                    chunk->compression.substr(0, 40))};
    if (cut)
        return {std::move(records->bytes),
                translate("leitstand::Error", "the chunk is cut off; its beginning is read")};
    if (!records->whole || records->bytes.size() != chunk->size)
        return {{},
                leitstand::fill(translate("leitstand::Error",
                                          "expected a chunk of {} bytes, found {} that can be decompressed"),
                                chunk->size, records->bytes.size())};
    if (chunk->crc != 0 && crcOf(records->bytes) != chunk->crc)
        return {{}, translate("leitstand::Error", "the chunk is damaged: its checksum is wrong")};
    return {std::move(records->bytes), {}};
}

}  // namespace leitstand::detail
