#include "core/perception/pictures/coding/picture_file.h"

#include <algorithm>
#include <array>

#include "core/perception/pictures/coding/picture_bytes.h"

namespace leitstand {
namespace {

using Bytes = std::span<const std::byte>;
using namespace picture_bytes;
constexpr std::array<unsigned char, 8> PngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// Signature, length, "IHDR", width, height.
Result<PictureFileSize> pngSize(Bytes bytes) {
    if (bytes.size() < 24 || at(bytes, 12) != 'I' || at(bytes, 13) != 'H' || at(bytes, 14) != 'D' ||
        at(bytes, 15) != 'R') {
        return Error{"PNG: expected the chunk IHDR at the beginning"};
    }
    return PictureFileSize{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
}

/// Walks from segment to segment up to the frame: marker, length, precision, height, width.
Result<PictureFileSize> jpegSize(Bytes bytes) {
    std::size_t i = 2;
    while (i + 4 <= bytes.size()) {
        if (at(bytes, i) != 0xff) break;
        const unsigned marker = at(bytes, i + 1);
        if (marker == 0xff) {  // filling
            ++i;
            continue;
        }
        if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {  // alone, without a length
            i += 2;
            continue;
        }
        if (isJpegFrame(marker)) {
            if (i + 9 > bytes.size()) break;
            return PictureFileSize{bigEndian(bytes, i + 7, 2), bigEndian(bytes, i + 5, 2)};
        }
        if (marker == 0xda || marker == 0xd9) break;  // the data begin, or end
        i += 2 + static_cast<std::size_t>(bigEndian(bytes, i + 2, 2));
    }
    return Error{"JPEG: expected a frame header (SOF) before the data"};
}

}  // namespace

PictureFileKind pictureFileKind(Bytes bytes) {
    if (bytes.size() >= 3 && at(bytes, 0) == 0xff && at(bytes, 1) == 0xd8 && at(bytes, 2) == 0xff) {
        return PictureFileKind::Jpeg;
    }
    if (bytes.size() >= PngSignature.size() &&
        std::equal(PngSignature.begin(), PngSignature.end(), bytes.begin(),
                   [](unsigned char a, std::byte b) { return a == std::to_integer<unsigned char>(b); })) {
        return PictureFileKind::Png;
    }
    return PictureFileKind::Unknown;
}

Result<PictureFileSize> pictureFileSize(Bytes bytes) {
    const PictureFileKind kind = pictureFileKind(bytes);
    if (kind == PictureFileKind::Unknown) return Error{"expected a JPEG or PNG file"};
    auto size = kind == PictureFileKind::Png ? pngSize(bytes) : jpegSize(bytes);
    if (size && (size->width == 0 || size->height == 0)) return Error{"expected a picture of some size"};
    return size;
}

}  // namespace leitstand
