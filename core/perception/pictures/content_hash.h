#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand {

/// Returns a hash of a picture's bytes, compressed or raw (FNV-1a over words). It is used to detect a driver
/// that sends the same picture again and again with new stamps.
[[nodiscard]] std::uint64_t contentHash(std::span<const std::byte> bytes);

}  // namespace leitstand
