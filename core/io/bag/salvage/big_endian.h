#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand::detail {

/// The big-endian number of 2 bytes at the beginning of @p bytes.
[[nodiscard]] inline std::uint32_t bigEndian16(std::span<const std::byte> bytes) {
    return (std::to_integer<std::uint32_t>(bytes[0]) << 8U) | std::to_integer<std::uint32_t>(bytes[1]);
}

/// The big-endian number of 4 bytes at the beginning of @p bytes.
[[nodiscard]] inline std::uint32_t bigEndian32(std::span<const std::byte> bytes) {
    return (bigEndian16(bytes) << 16U) | bigEndian16(bytes.subspan(2));
}

}  // namespace leitstand::detail
