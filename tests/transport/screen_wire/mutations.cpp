#include "tests/transport/screen_wire/mutations.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace leitstand::test {
namespace {

constexpr std::size_t HeaderSize = 20, MostBytes = 65'000;
constexpr unsigned Participants = 8;  // whose ports are tried

/// Where each submessage begins, as far as their lengths say.
std::vector<std::size_t> submessagesOf(const std::vector<std::byte>& bytes) {
    std::vector<std::size_t> begins;
    for (std::size_t at = HeaderSize; at + 4 <= bytes.size();) {
        begins.push_back(at);
        const bool little = (bytes[at + 1] & std::byte{1}) != std::byte{0};
        const auto low = std::to_integer<std::size_t>(bytes[at + (little ? 2 : 3)]);
        const auto high = std::to_integer<std::size_t>(bytes[at + (little ? 3 : 2)]);
        at += 4 + ((high << 8 | low) + 3) / 4 * 4;
    }
    return begins;
}

}  // namespace

void Mutator::anywhere(std::vector<std::byte>& bytes) {
    const std::size_t protect = below(20) == 0 ? 0 : HeaderSize;
    for (std::size_t change = 1 + below(8); change > 0; --change)
        bytes[protect + below(bytes.size() - protect)] = static_cast<std::byte>(m_random());
    switch (below(6)) {
        case 0:
            bytes.resize(HeaderSize + below(bytes.size() - HeaderSize));
            break;
        case 1:
            bytes.resize(bytes.size() + 1 + below(64));
            break;
        case 2: {
            const auto& other = m_recorded[below(m_recorded.size())].bytes;
            bytes.insert(bytes.end(), other.begin() + HeaderSize, other.end());
            break;
        }
        default:
            break;
    }
}

void Mutator::inFields(std::vector<std::byte>& bytes) {
    static constexpr std::uint32_t Values[] = {0,          1,          0xffffffff, 0x7fffffff, 0x80000000,
                                               0x40000000, 0x00010000, 0xfffffffe, 56,         257};
    const auto begins = submessagesOf(bytes);
    if (begins.empty()) return anywhere(bytes);
    const std::size_t at = begins[below(begins.size())];
    const std::size_t room = std::min<std::size_t>(bytes.size() - at, 64);
    if (below(8) == 0) {
        static constexpr unsigned Kinds[] = {0x80, 0x07, 0x08, 0x06, 0x12, 0x13,
                                             0x16, 0x15, 0x30, 0x33, 0x0c};
        bytes[at] = static_cast<std::byte>(Kinds[below(std::size(Kinds))]);
    }
    if (room < 12) return;
    const std::size_t field = at + 4 * below(room / 4);
    const std::uint32_t value =
        below(3) == 0 ? static_cast<std::uint32_t>(below(100'000)) : Values[below(std::size(Values))];
    if (field + 4 <= bytes.size()) std::memcpy(bytes.data() + field, &value, 4);
}

void Mutator::inPayload(std::vector<std::byte>& bytes) {
    const auto begins = submessagesOf(bytes);
    std::vector<std::size_t> samples;
    for (const std::size_t at : begins) {
        const auto kind = std::to_integer<unsigned>(bytes[at]);
        if (kind == 0x15 || kind == 0x16) samples.push_back(at);
    }
    if (samples.empty()) return inFields(bytes);
    const std::size_t at = samples[below(samples.size())] + 24;
    if (at + 8 >= bytes.size()) return inFields(bytes);
    const std::size_t end = std::min(bytes.size(), at + 600);
    for (std::size_t change = 1 + below(6); change > 0; --change) {
        const std::uint32_t value =
            below(2) == 0 ? static_cast<std::uint32_t>(m_random()) : 0xffffffff >> below(32);
        std::memcpy(bytes.data() + at + below((end - at) / 4) * 4, &value, 4);
    }
}

std::vector<std::byte> Mutator::next(Mutation how) {
    std::vector<std::byte> bytes;
    do {
        bytes = m_recorded[below(m_recorded.size())].bytes;
    } while (bytes.size() <= HeaderSize + 4);
    if (how == Mutation::Anywhere) anywhere(bytes);
    if (how == Mutation::InFields) inFields(bytes);
    if (how == Mutation::InPayload) inPayload(bytes);
    if (bytes.size() > MostBytes) bytes.resize(MostBytes);
    return bytes;
}

Attacker::Attacker(int domain) : m_socket(socket(AF_INET, SOCK_DGRAM, 0)), m_base(7400 + 250 * domain) {
    if (m_socket < 0) throw std::runtime_error("no socket");
    const in_addr loopback = {.s_addr = htonl(INADDR_LOOPBACK)};
    setsockopt(m_socket, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
    const int none = 0;  // never beyond this computer
    setsockopt(m_socket, IPPROTO_IP, IP_MULTICAST_TTL, &none, sizeof none);
}

Attacker::~Attacker() {
    close(m_socket);
}

void Attacker::sendTo(std::uint16_t port, bool group, const std::vector<std::byte>& bytes) const {
    sockaddr_in to = {};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = group ? inet_addr("239.255.0.1") : htonl(INADDR_LOOPBACK);
    sendto(m_socket, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
}

void Attacker::send(const std::vector<std::byte>& bytes) {
    const unsigned which = m_next++ % (2 * Participants + 1);
    if (which == 0) return sendTo(static_cast<std::uint16_t>(m_base), true, bytes);
    sendTo(static_cast<std::uint16_t>(m_base + 10 + int(which) - 1), false, bytes);
}

void Attacker::announce(const std::vector<std::byte>& bytes) {
    sendTo(static_cast<std::uint16_t>(m_base), true, bytes);
    for (unsigned i = 0; i < Participants; ++i)
        sendTo(static_cast<std::uint16_t>(m_base + 10 + 2 * int(i)), false, bytes);
}

}  // namespace leitstand::test
