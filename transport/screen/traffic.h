#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand::screen {

/// What a datagram carries, as far as its bytes show.
enum class Traffic : std::uint8_t {
    Samples,    ///< of topics, and what belongs to them
    Discovery,  ///< of entities that every participant has: who is there, proofs and keys, who reads and
                ///< writes what
    Encrypted,  ///< either of them: the content is hidden
};

/// Returns what a datagram carries, judged by the headers of its submessages; @p bytes may be only its
/// beginning.
[[nodiscard]] Traffic trafficOf(std::span<const std::byte> bytes);

}  // namespace leitstand::screen
