#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace leitstand::detail {

/// Size that socket buffers should have. With smaller buffers, fragments of 1 MB samples are lost faster than
/// readers can request them again.
inline constexpr std::uint32_t SocketBufferSize = 4'194'304;  // [B]

/// Returns a warning for each system limit in @p folder (/proc/sys/net/core) that is below SocketBufferSize,
/// with the command that raises it. Skips limits that cannot be read.
[[nodiscard]] std::vector<std::string> socketBufferWarnings(
    const std::filesystem::path& folder = "/proc/sys/net/core");

}  // namespace leitstand::detail
