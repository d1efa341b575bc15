#pragma once

#include <random>

#include "tests/transport/screen_wire/recorded_traffic.h"

namespace leitstand::test {

/// What is done to a packet of real traffic before it is sent again.
enum class Mutation : std::uint8_t {
    Anywhere,  ///< bytes, cuts, additions, submessages of other packets
    InFields,  ///< numbers, counts and lengths of its submessages become huge, zero or near by
    InPayload  ///< well formed around samples and announcements whose bytes are others
};

/// Packets that are hostile, made of @p recorded ones; the same for the same @p seed.
class Mutator {
public:
    Mutator(std::vector<RecordedPacket> recorded, unsigned seed)
        : m_recorded(std::move(recorded)), m_random(seed) {}
    [[nodiscard]] std::vector<std::byte> next(Mutation how);

private:
    void anywhere(std::vector<std::byte>& bytes);
    void inFields(std::vector<std::byte>& bytes);
    void inPayload(std::vector<std::byte>& bytes);
    [[nodiscard]] std::size_t below(std::size_t limit) { return limit == 0 ? 0 : m_random() % limit; }

    std::vector<RecordedPacket> m_recorded;
    std::mt19937 m_random;
};

/// Sends datagrams over loopback to the ports of @p domain's first participants, and to the group of
/// discovery.
class Attacker {
public:
    explicit Attacker(int domain);
    ~Attacker();
    Attacker(const Attacker&) = delete;
    Attacker& operator=(const Attacker&) = delete;

    /// To one of the ports, one after the other.
    void send(const std::vector<std::byte>& bytes);
    /// To the ports of discovery alone.
    void announce(const std::vector<std::byte>& bytes);

private:
    void sendTo(std::uint16_t port, bool group, const std::vector<std::byte>& bytes) const;
    int m_socket = -1;
    int m_base;
    unsigned m_next = 0;
};

}  // namespace leitstand::test
