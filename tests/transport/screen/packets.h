#pragma once

#include <bit>
#include <string>
#include <vector>

#include "transport/screen/screen.h"

namespace leitstand::test {

using Bytes = std::vector<std::byte>;

/// Bytes as RTPS writes them, in either byte order.
class ByteWriter {
public:
    explicit ByteWriter(bool little = true) : m_little(little) {}
    ByteWriter& u8(unsigned value) { return number(value, 1); }
    ByteWriter& u16(unsigned value) { return number(value, 2); }
    ByteWriter& u32(std::uint64_t value) { return number(value, 4); }
    ByteWriter& sequenceNumber(std::int64_t value) {
        return u32(std::uint64_t(value) >> 32).u32(std::uint64_t(value) & 0xffffffff);
    }
    ByteWriter& entity(screen::EntityId id) {
        for (int shift = 24; shift >= 0; shift -= 8) u8(id >> shift & 0xff);
        return *this;
    }
    ByteWriter& text(const std::string& value) {
        u32(value.size() + 1);
        for (const char c : value) u8(static_cast<unsigned char>(c));
        return zeros(1 + (4 - (value.size() + 1) % 4) % 4);
    }
    ByteWriter& zeros(std::size_t count) {
        bytes.resize(bytes.size() + count);
        return *this;
    }
    ByteWriter& append(const Bytes& more) {
        bytes.insert(bytes.end(), more.begin(), more.end());
        return *this;
    }
    ByteWriter& prefix(const screen::Prefix& value) {
        for (const std::uint8_t byte : value) u8(byte);
        return *this;
    }
    ByteWriter& parameter(unsigned id, const Bytes& value) {
        return u16(id).u16(static_cast<unsigned>(value.size())).append(value);
    }

    Bytes bytes;

private:
    ByteWriter& number(std::uint64_t value, int size) {
        for (int i = 0; i < size; ++i)
            bytes.push_back(static_cast<std::byte>(value >> 8 * (m_little ? i : size - 1 - i)));
        return *this;
    }
    bool m_little;
};

[[nodiscard]] inline screen::Prefix prefixOf(int number) {
    return {1, 15, std::uint8_t(number >> 8), std::uint8_t(number)};
}

/// A datagram of the participant @p number, made of submessages that are right unless asked otherwise.
class Packet {
public:
    explicit Packet(int number = 1, bool little = true) : m_prefix(prefixOf(number)), m_little(little) {
        ByteWriter header;
        for (const char c : {'R', 'T', 'P', 'S'}) header.u8(static_cast<unsigned char>(c));
        m_bytes = header.u8(2).u8(2).u8(1).u8(15).prefix(m_prefix).bytes;
    }
    Packet& submessage(unsigned kind, unsigned flags, const Bytes& content, int length = -1) {
        ByteWriter out(m_little);
        out.u8(kind).u8(flags | (m_little ? 1 : 0));
        out.u16(length < 0 ? static_cast<unsigned>(content.size()) : static_cast<unsigned>(length));
        out.append(content);
        m_bytes.insert(m_bytes.end(), out.bytes.begin(), out.bytes.end());
        return *this;
    }
    Packet& heartbeat(screen::EntityId writer, std::int64_t first, std::int64_t last,
                      std::uint32_t count = 1) {
        return submessage(
            0x07, 0,
            word().entity(0).entity(writer).sequenceNumber(first).sequenceNumber(last).u32(count).bytes);
    }
    Packet& gap(screen::EntityId writer, std::int64_t start, std::int64_t base, std::uint32_t bits = 0) {
        return submessage(0x08, 0,
                          word()
                              .entity(0)
                              .entity(writer)
                              .sequenceNumber(start)
                              .sequenceNumber(base)
                              .u32(bits)
                              .zeros((bits + 31) / 32 * 4)
                              .bytes);
    }
    Packet& acknowledge(screen::EntityId reader, screen::EntityId writer, std::int64_t base,
                        std::uint32_t count, std::uint32_t bits = 0) {
        return submessage(0x06, 0,
                          word()
                              .entity(reader)
                              .entity(writer)
                              .sequenceNumber(base)
                              .u32(bits)
                              .zeros((bits + 31) / 32 * 4)
                              .u32(count)
                              .bytes);
    }
    Packet& data(screen::EntityId writer, std::int64_t number, const Bytes& payload,
                 const Bytes& inlineQos = {}) {
        return submessage(0x15, inlineQos.empty() ? 4 : 6,
                          word()
                              .u16(0)
                              .u16(16)
                              .entity(0)
                              .entity(writer)
                              .sequenceNumber(number)
                              .append(inlineQos)
                              .append(payload)
                              .bytes);
    }
    Packet& fragments(screen::EntityId writer, std::int64_t number, std::uint32_t start, unsigned count,
                      unsigned size, std::uint32_t sample, const Bytes& payload) {
        return submessage(0x16, 0,
                          word()
                              .u16(0)
                              .u16(28)
                              .entity(0)
                              .entity(writer)
                              .sequenceNumber(number)
                              .u32(start)
                              .u16(count)
                              .u16(size)
                              .u32(sample)
                              .append(payload)
                              .bytes);
    }
    /// Tells of itself, and that it hears on these ports.
    Packet& announcePorts(const std::vector<unsigned>& discovery, const std::vector<unsigned>& samples) {
        ByteWriter out = word();
        out.append(parameters()).parameter(0x0050, ByteWriter().prefix(m_prefix).entity(0x000001c1).bytes);
        for (const unsigned port : discovery) out.parameter(0x0032, locator(7, port));
        for (const unsigned port : samples) out.parameter(0x0031, locator(7, port));
        return data(screen::entity::ParticipantWriter, 1, out.parameter(1, {}).bytes);
    }
    /// Tells of itself: with @p lease [s], from 10.0.0.@p host; 0: from loopback, where nobody listens.
    Packet& announce(unsigned lease = 100, int host = 7, std::int64_t number = 1,
                     const std::string& name = "robot") {
        return data(screen::entity::ParticipantWriter, number, announcement(lease, host, name));
    }
    Packet& announceEndpoint(screen::EntityId endpoint, bool writer = true, std::int64_t number = 1) {
        ByteWriter out = word();
        out.append(parameters()).parameter(0x005a, ByteWriter().prefix(m_prefix).entity(endpoint).bytes);
        out.parameter(0x0005, word().text("rt/somebody/topic" + std::to_string(endpoint)).bytes);
        out.parameter(0x0007, word().text("std_msgs::msg::dds_::String_").bytes).parameter(1, {});
        return data(writer ? screen::entity::PublicationsWriter : screen::entity::SubscriptionsWriter, number,
                    out.bytes);
    }
    /// Takes back what the participant @p whose announced of @p entity by its @p writer.
    Packet& end(int whose, screen::EntityId writer, screen::EntityId entity) {
        const Bytes guid = ByteWriter().prefix(prefixOf(whose)).entity(entity).bytes;
        const Bytes qos = word()
                              .parameter(0x0070, guid)
                              .parameter(0x0071, ByteWriter(false).u32(3).bytes)
                              .parameter(1, {})
                              .bytes;
        return submessage(0x15, 2,
                          word().u16(0).u16(16).entity(0).entity(writer).sequenceNumber(9).append(qos).bytes);
    }
    Packet& endParticipant(int whose) { return end(whose, screen::entity::ParticipantWriter, 0x000001c1); }
    /// What begins a proof of identity.
    [[nodiscard]] static Bytes identityToken() {
        ByteWriter token(true);
        token.append(ByteWriter(false).u16(1).u16(0).bytes)
            .zeros(2 * 24 + 3 * 16)
            .text("dds.sec.auth")
            .u32(1);
        return token.text("DDS:Auth:PKI-DH:1.0+Req").u32(0).u32(1).text("c.id").u32(4).zeros(4).bytes;
    }
    Packet& statistics() { return submessage(0x80, 0, Bytes(56)); }

    [[nodiscard]] Bytes announcement(unsigned lease, int host, const std::string& name) const {
        ByteWriter out = word();
        out.append(parameters()).parameter(0x0050, ByteWriter().prefix(m_prefix).entity(0x000001c1).bytes);
        out.parameter(0x0002, word().u32(lease).u32(0).bytes).parameter(0x0062, word().text(name).bytes);
        out.parameter(0x0015, word().u8(2).u8(2).u16(0).bytes)
            .parameter(0x0016, word().u8(1).u8(15).u16(0).bytes);
        out.parameter(0x0058, word().u32(0x0c3f).bytes);  // has all that the standard wants
        return out.parameter(0x0032, locator(host, host == 0 ? 9 : 7410)).parameter(1, {}).bytes;
    }
    /// UDP at 10.0.0.@p host; 0: at loopback.
    [[nodiscard]] Bytes locator(int host, unsigned port) const {
        ByteWriter out = word();
        out.u32(1).u32(port).zeros(12).u8(host == 0 ? 127 : 10).u8(0).u8(0);
        return out.u8(host == 0 ? 1 : static_cast<unsigned>(host)).bytes;
    }
    [[nodiscard]] Bytes parameters() const { return ByteWriter(false).u16(m_little ? 3 : 2).u16(0).bytes; }
    [[nodiscard]] ByteWriter word() const { return ByteWriter(m_little); }
    [[nodiscard]] const Bytes& bytes() const { return m_bytes; }

private:
    screen::Prefix m_prefix;
    bool m_little;
    Bytes m_bytes;
};

/// 10.0.0.@p host, port @p port.
[[nodiscard]] inline screen::Place placeOf(int host, int port = 40'000) {
    screen::Place place;
    place.address = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 10, 0, 0, std::uint8_t(host)};
    place.port = static_cast<std::uint16_t>(port);
    return place;
}

constexpr screen::EntityId OdometryWriter = 0x00000103, OdometryReader = 0x00000104;

}  // namespace leitstand::test
