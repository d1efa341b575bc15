#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// Helpers that the readers of JPEG and PNG files share.
namespace leitstand::picture_bytes {

inline unsigned at(std::span<const std::byte> bytes, std::size_t i) {
    return std::to_integer<unsigned>(bytes[i]);
}

/// Returns the big-endian number of @p count bytes at @p first.
inline std::int64_t bigEndian(std::span<const std::byte> bytes, std::size_t first, std::size_t count) {
    std::int64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | at(bytes, first + i);
    return value;
}

/// Whether a JPEG's marker begins a frame (ITU T.81, table B.1), not DHT, JPG or DAC.
inline bool isJpegFrame(unsigned marker) {
    return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

}  // namespace leitstand::picture_bytes
