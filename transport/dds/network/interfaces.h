#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand::detail {

/// Returns the IPv4 addresses of @p interfaces (names or addresses of this computer). The error names the
/// unknown interface and lists those of this computer.
[[nodiscard]] Result<std::vector<std::string>> addressesOf(const std::vector<std::string>& interfaces);

/// An address and a port.
struct Peer {
    std::string address;     ///< IPv4, "192.168.0.7"
    std::uint16_t port = 0;  ///< 0: not given
};
/// Reads "192.168.0.7", "robot.local:7410"; looks up names now. Errors name @p setting.
[[nodiscard]] Result<Peer> parsePeer(const std::string& text, const std::string& setting);

}  // namespace leitstand::detail
