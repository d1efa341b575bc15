#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// Reads a sample in XCDR1 with its encapsulation header, in either byte order. After the first field that
/// does not fit, further reads do not change numbers and structures, and make texts and sequences empty.
/// finish() reports what was wrong. Memory for a sequence is allocated only if the sample has enough bytes
/// for its count. Texts and structures take more memory than their bytes in the sample, so a sequence of them
/// has at most 100 000 elements.
class CdrReader {
public:
    explicit CdrReader(std::span<const std::byte> sample);

    void read(const char* field, bool& to);
    void read(const char* field, std::string& to);
    /// Sets @p to to a view of bytes in the sample, which must outlive it.
    void read(const char* field, std::span<const std::byte>& to);
    void read(const char* field, std::vector<std::string>& to);

    template <class T>
    void read(const char* field, T& to) {
        if constexpr (std::is_arithmetic_v<T>) {
            if (const std::byte* from = take(field, sizeof(T), sizeof(T))) copy(from, &to, 1);
        } else {
            if (ok()) decode(*this, to);
        }
    }
    template <class T, std::size_t N>
    void read(const char* field, std::array<T, N>& to) {
        if (const std::byte* from = take(field, sizeof(T), N * sizeof(T))) copy(from, to.data(), N);
    }
    template <class T>
    void read(const char* field, std::vector<T>& to) {
        if constexpr (std::is_arithmetic_v<T>) {
            const std::size_t count = readCount(field, sizeof(T));
            if (count == 0) return to.clear();
            const std::byte* from = take(field, sizeof(T), count * sizeof(T));
            if (from == nullptr) return;
            to.resize(count);
            copy(from, to.data(), count);
        } else {
            to.resize(readStructureCount(field, T::LeastSize));
            for (T& element : to) {
                if (!ok()) return;
                decode(*this, element);
            }
        }
    }

    /// Call after the last field. Error: a field did not fit, or more than 7 bytes (padding) are left.
    [[nodiscard]] Result<void> finish();
    [[nodiscard]] bool ok() const { return m_error.empty(); }

private:
    /// Returns a pointer to @p size bytes after the padding for @p alignment; null when there are fewer.
    const std::byte* take(const char* field, std::size_t alignment, std::size_t size);
    /// Reads the count of a sequence whose elements have at least @p leastSize bytes each; 0: it does not
    /// fit.
    std::size_t readCount(const char* field, std::size_t leastSize);
    std::size_t readStructureCount(const char* field, std::size_t leastSize);
    void fail(std::string text);

    template <class T>
    void copy(const std::byte* from, T* to, std::size_t count) const {
        std::memcpy(to, from, count * sizeof(T));
        if (m_swap) swapBytes(reinterpret_cast<std::byte*>(to), sizeof(T), count);
    }
    static void swapBytes(std::byte* values, std::size_t size, std::size_t count);

    std::span<const std::byte> m_body;  // without the encapsulation header, which alignment ignores
    std::size_t m_at = 0;
    bool m_swap = false;
    std::string m_error;
};

}  // namespace leitstand
