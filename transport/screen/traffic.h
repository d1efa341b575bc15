#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand::screen {

/// What a datagram carries, as far as its bytes tell.
enum class Traffic : std::uint8_t {
    Samples,    ///< of topics, and what belongs to them
    Discovery,  ///< of entities that every participant has: who is there, proofs and keys, who reads and
                ///< writes what
    Encrypted,  ///< either: whose it is cannot be seen
};

/// Tells by the heads of its submessages what a datagram carries; @p bytes may be its beginning alone.
[[nodiscard]] Traffic trafficOf(std::span<const std::byte> bytes);

}  // namespace leitstand::screen
