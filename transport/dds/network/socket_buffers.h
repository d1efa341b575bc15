#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace leitstand::detail {

/// What sockets should hold: with less, samples of 1 MB lose pieces faster than they can be asked for again.
inline constexpr std::uint32_t SocketBufferSize = 4'194'304;  // [B]

/// Which limits of the system under @p folder (/proc/sys/net/core) are below SocketBufferSize, with the
/// command that lifts each. Limits that cannot be read are passed over.
[[nodiscard]] std::vector<std::string> socketBufferWarnings(
    const std::filesystem::path& folder = "/proc/sys/net/core");

}  // namespace leitstand::detail
