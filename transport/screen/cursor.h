#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace leitstand::screen {

/// Reads a part of a datagram in either byte order. After the first read that does not fit, all further reads
/// return zero and ok() is false.
class Cursor {
public:
    Cursor(std::span<const std::byte> bytes, bool little) : m_bytes(bytes), m_little(little) {}

    [[nodiscard]] bool ok() const { return m_ok; }
    [[nodiscard]] std::size_t left() const { return m_bytes.size(); }
    void setLittle(bool little) { m_little = little; }

    /// Returns the next @p size bytes; empty when there are fewer.
    std::span<const std::byte> take(std::size_t size) {
        if (!m_ok || size > m_bytes.size()) {
            m_ok = false;
            m_bytes = {};
            return {};
        }
        const auto taken = m_bytes.first(size);
        m_bytes = m_bytes.subspan(size);
        return taken;
    }
    std::span<const std::byte> rest() { return take(m_bytes.size()); }
    /// Skips the padding after @p size bytes, up to a multiple of four. Stops at the end of the data.
    void skipPadding(std::size_t size) { take(std::min((4 - size % 4) % 4, m_bytes.size())); }

    std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
    std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
    std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
    /// Reads the number of a sample in the format of RTPS: the high half comes first, in either byte order.
    std::int64_t sequenceNumber() {
        const std::uint64_t high = u32();
        return static_cast<std::int64_t>(high << 32 | u32());
    }
    /// Reads the id of an entity, which is always big-endian.
    std::uint32_t entityId() {
        std::uint32_t id = 0;
        for (const std::byte byte : take(4)) id = id << 8 | std::to_integer<std::uint32_t>(byte);
        return id;
    }
    template <std::size_t N>
    std::array<std::uint8_t, N> octets() {
        std::array<std::uint8_t, N> to{};
        if (const auto from = take(N); !from.empty()) std::memcpy(to.data(), from.data(), N);
        return to;
    }

private:
    std::uint64_t number(std::size_t size) {
        std::uint64_t value = 0;
        const auto from = take(size);
        for (std::size_t i = 0; i < from.size(); ++i) {
            const auto byte = std::to_integer<std::uint64_t>(from[i]);
            value |= byte << 8 * (m_little ? i : size - 1 - i);
        }
        return value;
    }

    std::span<const std::byte> m_bytes;
    bool m_little = true, m_ok = true;
};

}  // namespace leitstand::screen
