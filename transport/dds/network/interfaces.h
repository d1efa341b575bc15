#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand::detail {

/// Returns the IPv4 addresses of @p interfaces (names or addresses of this computer). The error has the
/// unknown interface and lists those of this computer.
[[nodiscard]] Result<std::vector<std::string>> addressesOf(const std::vector<std::string>& interfaces);

/// An address and a port.
struct Peer {
    std::string address;     ///< IPv4, "192.168.0.7"
    std::uint16_t port = 0;  ///< 0: not given
};
/// Parses "192.168.0.7" or "robot.local:7410". Names are looked up now. Errors name @p setting.
[[nodiscard]] Result<Peer> parsePeer(const std::string& text, const std::string& setting);

}  // namespace leitstand::detail
