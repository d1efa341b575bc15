#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace leitstand::screen {

/// What a datagram contains, as far as can be seen.
enum class Traffic : std::uint8_t {
    Samples,  ///< samples of topics, and submessages that belong to them
    /// Traffic of the entities that every participant has: announcements of participants, writers and
    /// readers, proofs of identity, keys.
    Discovery,
    Encrypted,  ///< samples or discovery: the content is encrypted
};

/// Returns what a datagram contains, according to the headers of its submessages. @p bytes: the datagram, or
/// only its beginning.
[[nodiscard]] Traffic trafficOf(std::span<const std::byte> bytes);

}  // namespace leitstand::screen
