#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand {

/// A number that differs between pictures that differ (FNV-1a over words), of their compressed or raw bytes:
/// a driver that stamps one picture again and again is found out by it.
[[nodiscard]] std::uint64_t contentHash(std::span<const std::byte> bytes);

}  // namespace leitstand
