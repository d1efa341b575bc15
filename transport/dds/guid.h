#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>

namespace leitstand {

/// Identity of a participant, writer or reader in its domain (RTPS 2.2, section 8.2.4): 12 bytes of its
/// participant and 4 bytes of its own.
struct Guid {
    std::array<std::uint8_t, 16> bytes{};
    friend auto operator<=>(const Guid&, const Guid&) = default;
};

/// A sample of an endpoint, by the number that its writer gave it (RTPS 2.2, section 8.7.9).
struct SampleIdentity {
    Guid endpoint;
    std::uint64_t number = 0;  ///< from 1
    friend bool operator==(const SampleIdentity&, const SampleIdentity&) = default;
};

/// Formats @p guid as "010f1a2b.3c4d0000.00000000.000001c1".
[[nodiscard]] std::string toString(const Guid& guid);

}  // namespace leitstand
