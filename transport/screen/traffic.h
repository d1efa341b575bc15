#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand::screen {

/// What a datagram carries, as far as its bytes show.
enum class Traffic : std::uint8_t {
    Samples,    ///< samples of topics, and submessages that belong to them
    Discovery,  ///< traffic of the entities that every participant has: announcements of participants,
                ///< writers and readers, proofs of identity, keys
    Encrypted,  ///< samples or discovery: the content is hidden
};

/// Returns what a datagram carries, by the headers of its submessages. @p bytes: the datagram, or only its
/// beginning.
[[nodiscard]] Traffic trafficOf(std::span<const std::byte> bytes);

}  // namespace leitstand::screen
