#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace leitstand::screen {

using Address = std::array<std::uint8_t, 16>;  ///< address in a locator; IPv4 is in the last four bytes

/// Where a datagram comes from.
struct Place {
    Address address{};
    std::uint16_t port = 0;
    friend bool operator==(const Place&, const Place&) = default;
};

[[nodiscard]] inline bool isLoopback(const Address& address) {
    return address[12] == 127;
}
/// Formats @p address as "10.0.0.7".
[[nodiscard]] std::string toString(const Address& address);

/// Hash for tables whose keys are chosen by others.
struct BytesHash {
    template <std::size_t N>
    std::size_t operator()(const std::array<std::uint8_t, N>& bytes) const {
        std::uint64_t hash = Seed;
        for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
        return hash;
    }
    std::size_t operator()(const Place& place) const {
        return ((*this)(place.address) ^ place.port) * 0x9e3779b1;
    }

private:
    static const std::uint64_t Seed;  // random at each start: nobody can choose keys that collide
};

}  // namespace leitstand::screen
