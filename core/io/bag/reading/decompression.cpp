#include "core/io/bag/reading/decompression.h"

#include <algorithm>
#include <memory>

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

namespace leitstand::detail {
namespace {

constexpr std::size_t Step = 256U << 10U;  ///< that the output grows by at least [B]

/// Makes room for more in @p bytes, of which @p used are used, at most @p most in all; returns the room,
/// empty when there is none. @p input: size of what is compressed; what unpacks to a usual size gets room at
/// once.
std::span<std::byte> roomIn(std::vector<std::byte>& bytes, std::size_t used, std::size_t input,
                            std::uint64_t most) {
    constexpr std::uint64_t Usual = 32;  // times as large
    const std::uint64_t wanted = used == 0 ? std::max<std::uint64_t>(Step, Usual * input)
                                           : std::max<std::uint64_t>(used + Step, 2 * used);
    bytes.resize(static_cast<std::size_t>(std::min(wanted, most)));
    return std::span(bytes).subspan(used);
}

Decompressed byZstd(std::span<const std::byte> input, std::uint64_t most) {
    const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                            &ZSTD_freeDStream);
    Decompressed result;
    std::size_t used = 0;
    ZSTD_inBuffer in{input.data(), input.size(), 0};
    std::size_t left = 1;  // of a frame, as the library hints
    while (stream && (in.pos < in.size || left != 0)) {
        const std::span<std::byte> room = roomIn(result.bytes, used, input.size(), most);
        ZSTD_outBuffer out{room.data(), room.size(), 0};
        const std::size_t before = in.pos;
        left = ZSTD_decompressStream(stream.get(), &out, &in);
        used += out.pos;
        if (ZSTD_isError(left) != 0 || (out.pos == 0 && in.pos == before)) break;
        result.whole = left == 0 && in.pos == in.size;
    }
    result.bytes.resize(used);
    return result;
}

Decompressed byLz4(std::span<const std::byte> input, std::uint64_t most) {
    LZ4F_dctx* made = nullptr;
    Decompressed result;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) return result;
    const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
        made, &LZ4F_freeDecompressionContext);
    std::size_t used = 0, read = 0;
    std::size_t left = 1;  // of a frame, as the library hints
    while (read < input.size() || left != 0) {
        const std::span<std::byte> room = roomIn(result.bytes, used, input.size(), most);
        std::size_t produced = room.size(), consumed = input.size() - read;
        left =
            LZ4F_decompress(context.get(), room.data(), &produced, input.data() + read, &consumed, nullptr);
        if (LZ4F_isError(left) != 0) break;
        used += produced;
        read += consumed;
        if (produced == 0 && consumed == 0) break;
        result.whole = left == 0 && read == input.size();
    }
    result.bytes.resize(used);
    return result;
}

Decompressed byBzip2(std::span<const std::byte> input, std::uint64_t most) {
    constexpr std::size_t MostAtOnce = 1U << 30U;  // the library counts in unsigned int
    bz_stream stream{};
    Decompressed result;
    if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return result;
    stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(input.data()));
    stream.avail_in = static_cast<unsigned>(std::min(input.size(), MostAtOnce));
    std::size_t used = 0;
    for (int state = BZ_OK; state == BZ_OK;) {
        const std::span<std::byte> room = roomIn(result.bytes, used, input.size(), most);
        const auto most32 = static_cast<unsigned>(std::min(room.size(), MostAtOnce));
        stream.next_out = reinterpret_cast<char*>(room.data());
        stream.avail_out = most32;
        const unsigned before = stream.avail_in;
        state = BZ2_bzDecompress(&stream);
        used += most32 - stream.avail_out;
        result.whole = state == BZ_STREAM_END && stream.avail_in == 0;
        if (stream.avail_out == most32 && stream.avail_in == before) break;  // nothing goes on
    }
    BZ2_bzDecompressEnd(&stream);
    result.bytes.resize(used);
    return result;
}

}  // namespace

std::optional<Decompressed> decompressed(std::span<const std::byte> input, std::string_view format,
                                         std::uint64_t most) {
    if (format == "zstd") return byZstd(input, most);
    if (format == "lz4") return byLz4(input, most);
    if (format == "bz2") return byBzip2(input, most);
    if (!format.empty()) return std::nullopt;
    const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(input.size(), most));
    return Decompressed{{input.begin(), input.begin() + static_cast<std::ptrdiff_t>(size)},
                        size == input.size()};
}

}  // namespace leitstand::detail
