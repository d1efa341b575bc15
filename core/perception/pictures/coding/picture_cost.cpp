#include "core/perception/pictures/coding/picture_cost.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include <zlib.h>

#include "core/base/words.h"
#include "core/perception/pictures/coding/picture_bytes.h"

namespace leitstand {
namespace {

using Bytes = std::span<const std::byte>;
using namespace picture_bytes;

/// Facts from the segments of a JPEG.
struct JpegFacts {
    std::int64_t scans = 0;
    std::int64_t components = 3;
};

/// Walks over the file as decoders do, up to @p most scans; whatever is between segments is skipped.
JpegFacts jpegFacts(Bytes bytes, std::int64_t most) {
    JpegFacts facts;
    for (std::size_t i = 2; i + 1 < bytes.size() && facts.scans <= most;) {
        if (at(bytes, i++) != 0xff) continue;
        while (i < bytes.size() && at(bytes, i) == 0xff) ++i;
        if (i >= bytes.size()) break;
        const unsigned marker = at(bytes, i++);
        if (marker == 0xd9) break;                                           // the end
        if (marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8)) continue;  // without a length
        if (i + 2 > bytes.size()) break;
        const auto length = static_cast<std::size_t>(bigEndian(bytes, i, 2));
        if (isJpegFrame(marker) && i + 8 <= bytes.size()) facts.components = at(bytes, i + 7);
        if (marker == 0xda) ++facts.scans;
        i += std::max<std::size_t>(length, 2);
    }
    return facts;
}

Error tooLarge(std::int64_t most, std::int64_t found) {
    return Error{leitstand::fill(
        translate("leitstand::Error", "picture: expected at most {} bytes when it is decoded, found {}"),
        most, found)};
}

Result<void> checkJpeg(Bytes file, const PictureFileSize& size, const PictureLimits& limits) {
    const JpegFacts facts = jpegFacts(file, limits.maxScans);
    const std::int64_t pixels = size.width * size.height;
    if (pixels * facts.components > limits.maxFileBytes)
        return tooLarge(limits.maxFileBytes, pixels * facts.components);
    if (facts.scans > limits.maxScans || facts.scans * pixels > limits.maxScanPixels) {
        return Error{leitstand::fill(
            translate(
                "leitstand::Error",
                "picture: expected at most {} scans and {} pixels in all of them, found {} scans of {}"),
            limits.maxScans, limits.maxScanPixels, facts.scans, pixels)};
    }
    return {};
}

/// A chunk of a PNG: length, type, content, checksum.
struct Chunk {
    std::string_view type;
    Bytes all, content;
};

/// Calls @p take with the chunks of @p file; a truncated one is the last.
template <class Take>
void eachChunk(Bytes file, Take take) {
    constexpr std::size_t Signature = 8, Head = 8, Checksum = 4;
    for (std::size_t i = Signature; i + Head <= file.size();) {
        const auto length = static_cast<std::size_t>(bigEndian(file, i, 4));
        const std::size_t rest = file.size() - i;
        const Bytes all = file.subspan(i, std::min(rest, length + Head + Checksum));
        const Bytes content = all.subspan(Head, std::min(all.size() - Head, length));
        const std::string_view type(reinterpret_cast<const char*>(all.data()) + 4, 4);
        take(Chunk{type, all, content});
        if (type == "IEND") return;
        i += all.size();
    }
}

/// Bits of a pixel by the header's depth and colour type; 0: no such kind.
std::int64_t bitsOf(unsigned depth, unsigned colour) {
    constexpr std::array<std::int64_t, 7> Channels = {1, 0, 3, 1, 2, 0, 4};
    return depth <= 16 && colour < Channels.size() ? Channels[colour] * depth : 0;
}

/// Bytes that the data of a PNG inflate to: rows with a byte before each, in seven passes where it is
/// interlaced.
std::int64_t inflatedBytes(const PictureFileSize& size, std::int64_t bits, bool interlaced) {
    struct Pass {
        std::int64_t x, y, dx, dy;
    };
    constexpr std::array<Pass, 7> Passes = {
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    const auto rows = [bits](std::int64_t width, std::int64_t height) {
        return width > 0 && height > 0 ? height * (1 + (width * bits + 7) / 8) : 0;
    };
    if (!interlaced) return rows(size.width, size.height);
    std::int64_t sum = 0;
    for (const Pass& pass : Passes) {
        sum += rows((size.width - pass.x + pass.dx - 1) / pass.dx,
                    (size.height - pass.y + pass.dy - 1) / pass.dy);
    }
    return sum;
}

/// Whether @p data inflate to no more than @p most bytes, as far as they can be inflated.
bool inflatesTo(const std::vector<Bytes>& data, std::int64_t most) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return false;
    std::vector<unsigned char> out(std::size_t{1} << 16U);
    std::int64_t sum = 0;
    int code = Z_OK;
    for (std::size_t i = 0; i < data.size() && code == Z_OK && sum <= most; ++i) {
        stream.next_in = reinterpret_cast<unsigned char*>(const_cast<std::byte*>(data[i].data()));
        stream.avail_in = static_cast<unsigned>(data[i].size());
        do {
            stream.next_out = out.data();
            stream.avail_out = static_cast<unsigned>(out.size());
            code = inflate(&stream, Z_NO_FLUSH);
            sum += static_cast<std::int64_t>(out.size() - stream.avail_out);
        } while (code == Z_OK && sum <= most && (stream.avail_in > 0 || stream.avail_out == 0));
        if (code == Z_BUF_ERROR) code = Z_OK;  // it wants more
    }
    inflateEnd(&stream);
    return sum <= most;
}

/// Keeps what the pixels need: the cost of texts, profiles and the like is up to their sender.
Result<void> checkPng(AffordableFile& file, const PictureLimits& limits) {
    constexpr std::size_t Signature = 8, Header = 13;
    const Bytes whole = file.bytes;
    std::vector<Bytes> data;
    Bytes header;
    file.kept.assign(whole.begin(), whole.begin() + Signature);
    eachChunk(whole, [&](const Chunk& chunk) {
        constexpr std::array<std::string_view, 5> Needed = {"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
        if (std::find(Needed.begin(), Needed.end(), chunk.type) == Needed.end()) return;
        if (chunk.type == "IHDR" && header.empty()) header = chunk.content;
        if (chunk.type == "IDAT") data.push_back(chunk.content);
        file.kept.insert(file.kept.end(), chunk.all.begin(), chunk.all.end());
    });
    file.bytes = file.kept;
    const std::int64_t bits = header.size() < Header ? 0 : bitsOf(at(header, 8), at(header, 9));
    if (bits == 0)
        return Error{translate("leitstand::Error", "picture: PNG: expected a header of a known kind")};
    const std::int64_t pixels = file.size.width * file.size.height;
    const bool palette = at(header, 9) == 3;
    const std::int64_t decoded = pixels * (palette ? 4 : std::max<std::int64_t>(bits / 8, 1));
    if (decoded > limits.maxFileBytes) return tooLarge(limits.maxFileBytes, decoded);
    const std::int64_t inflated = inflatedBytes(file.size, bits, at(header, 12) != 0);
    if (!inflatesTo(data, inflated)) {
        return Error{
            leitstand::fill(translate("leitstand::Error",
                                      "picture: PNG: expected data of {} bytes for its pixels, found more"),
                            inflated)};
    }
    return {};
}

}  // namespace

Result<AffordableFile> affordableFile(Bytes file, const PictureLimits& limits) {
    const auto size = pictureFileSize(file);
    if (!size) return Error{leitstand::fill(translate("leitstand::Error", "picture: {}"), size.error().text)};
    const std::int64_t most = std::min(limits.maxPixels, limits.maxFilePixels);
    if (size->width > limits.maxSide || size->height > limits.maxSide || size->width * size->height > most) {
        return Error{leitstand::fill(
            translate("leitstand::Error",
                      "picture: expected 1 to {} pixels a side and at most {}, found {} x {}"),
            limits.maxSide, most, size->width, size->height)};
    }
    AffordableFile affordable{*size, {}, file};
    const auto checked = pictureFileKind(file) == PictureFileKind::Png ? checkPng(affordable, limits)
                                                                       : checkJpeg(file, *size, limits);
    if (!checked) return checked.error();
    return affordable;
}

}  // namespace leitstand
