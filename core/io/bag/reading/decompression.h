#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace leitstand::detail {

/// Bytes that were compressed, as far as they could be read.
struct Decompressed {
    std::vector<std::byte> bytes;
    bool whole = false;  ///< false: the input ends early, is damaged, or holds more than allowed
};

/// Returns @p input decompressed, at most @p most bytes of it. @p format: "zstd", "lz4" (frames), "bz2", or
/// empty for bytes as they are. Memory is taken as bytes come, so that a short input cannot claim much.
/// Empty: the format is unknown.
[[nodiscard]] std::optional<Decompressed> decompressed(std::span<const std::byte> input,
                                                       std::string_view format, std::uint64_t most);

}  // namespace leitstand::detail
