#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace leitstand {

/// Writes a sample in XCDR1 with its encapsulation header.
class CdrWriter {
public:
    /// Robots use the byte order of the machine, little-endian. Tests may choose the other one.
    explicit CdrWriter(std::endian order = std::endian::little);

    /// Avoids copies while a large sample is written.
    void reserve(std::size_t bytes) { m_bytes.reserve(bytes); }
    void write(bool value) { write(static_cast<std::uint8_t>(value)); }
    void write(const std::string& text);
    void write(std::span<const std::byte> bytes);
    void write(const std::vector<std::string>& texts);

    template <class T>
    void write(const T& value) {
        if constexpr (std::is_arithmetic_v<T>) {
            put(&value, sizeof(T), 1);
        } else {
            encode(*this, value);
        }
    }
    template <class T, std::size_t N>
    void write(const std::array<T, N>& values) {
        put(values.data(), sizeof(T), N);
    }
    template <class T>
    void write(const std::vector<T>& values) {
        write(static_cast<std::uint32_t>(values.size()));
        if constexpr (std::is_arithmetic_v<T>) {
            if (!values.empty()) put(values.data(), sizeof(T), values.size());
        } else {
            for (const T& value : values) encode(*this, value);
        }
    }

    /// Returns the whole sample; nothing can be written after this.
    [[nodiscard]] std::vector<std::byte> finish() && { return std::move(m_bytes); }

private:
    void put(const void* values, std::size_t size, std::size_t count);

    std::vector<std::byte> m_bytes;
    bool m_swap;
};

}  // namespace leitstand
