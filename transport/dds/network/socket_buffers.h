#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace leitstand::detail {

/// Size that socket buffers should have: with less, samples of 1 MB lose pieces faster than readers request
/// them again.
inline constexpr std::uint32_t SocketBufferSize = 4'194'304;  // [B]

/// Returns a warning for each system limit under @p folder (/proc/sys/net/core) that is below
/// SocketBufferSize, with the command that lifts it. Skips limits that cannot be read.
[[nodiscard]] std::vector<std::string> socketBufferWarnings(
    const std::filesystem::path& folder = "/proc/sys/net/core");

}  // namespace leitstand::detail
