#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand {

/// Returns a hash of a picture's compressed or raw bytes (FNV-1a over words). It detects a driver that stamps
/// one picture again and again.
[[nodiscard]] std::uint64_t contentHash(std::span<const std::byte> bytes);

}  // namespace leitstand
