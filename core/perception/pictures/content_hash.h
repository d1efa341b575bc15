#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand {

/// Returns a hash of a picture's compressed or raw bytes (FNV-1a over words). It serves to detect a driver
/// that stamps the same picture again and again.
[[nodiscard]] std::uint64_t contentHash(std::span<const std::byte> bytes);

}  // namespace leitstand
