#pragma once

#include <bit>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

namespace leitstand {

static_assert(std::endian::native == std::endian::little, "the bytes of checkpoints are little-endian");

/// Appends @p size bytes.
void append(std::vector<std::byte>& to, const void* bytes, std::size_t size);
/// Moves the first @p size bytes of @p from to @p into; false when there are fewer.
[[nodiscard]] bool extract(std::span<const std::byte>& from, void* into, std::size_t size);

/// Writes values as bytes, or reads values from bytes. A type lists its fields once for both directions, in a
/// free function `describe(archive, value)`: `archive(value.a, value.b)`. Reading is safe for any input: at
/// the first bytes that make no sense, ok() becomes false and further values keep their old content.
template <bool Writing>
class Archive {
public:
    static constexpr bool Writes = Writing;
    static constexpr std::size_t MostUnpacked = std::size_t{256} << 20U;

    Archive() requires Writing = default;
    explicit Archive(std::span<const std::byte> bytes) requires(!Writing) : m_rest(bytes) {}

    [[nodiscard]] bool ok() const { return m_ok; }
    [[nodiscard]] std::span<const std::byte> rest() const { return m_rest; }
    [[nodiscard]] std::vector<std::byte> take() { return std::move(m_bytes); }
    void fail() { m_ok = false; }
    /// Call before @p size bytes are unpacked from fewer bytes. Fails when all that was unpacked from these
    /// bytes takes more than MostUnpacked.
    [[nodiscard]] bool mayUnpack(std::size_t size) {
        m_unpacked += size;
        if (m_unpacked > MostUnpacked) fail();
        return m_ok;
    }
    /// The format version of the bytes. Bytes of an older version lack newer fields; see since() in
    /// checkpoint_fields.h.
    [[nodiscard]] std::uint32_t version() const { return m_version; }
    void setVersion(std::uint32_t version) { m_version = version; }

    template <class... Fields>
    void operator()(Fields&... fields) {
        (one(fields), ...);
    }

private:
    template <class T>
    static constexpr bool Plain = std::is_floating_point_v<T> ||
                                  (std::is_integral_v<T> && !std::same_as<T, bool>);

    void raw(void* bytes, std::size_t size) {
        if constexpr (Writing) {
            append(m_bytes, bytes, size);
        } else {
            m_ok = m_ok && extract(m_rest, bytes, size);
        }
    }

    /// Reads or writes the number of elements of a container; each element takes at least one byte.
    std::size_t count(std::size_t size) {
        auto number = static_cast<std::uint32_t>(size);
        raw(&number, sizeof number);
        if (!Writing && number > m_rest.size()) m_ok = false;
        return m_ok ? number : 0;
    }

    template <class T>
    requires Plain<T>
    void one(T& value) { raw(&value, sizeof value); }

    void one(bool& value) {
        std::uint8_t byte = value ? 1 : 0;
        raw(&byte, 1);
        if (byte > 1) m_ok = false;
        if constexpr (!Writing) value = byte == 1;
    }

    /// Reads or writes an enumeration. Refuses numbers above its last value, which lastOf() returns.
    template <class T>
    requires std::is_enum_v<T>
    void one(T& value) {
        auto number = static_cast<std::uint8_t>(value);
        raw(&number, 1);
        if (number > static_cast<std::uint8_t>(lastOf(value))) {
            m_ok = false;
        } else if constexpr (!Writing) {
            value = static_cast<T>(number);
        }
    }

    template <class Rep, class Period>
    void one(std::chrono::duration<Rep, Period>& value) {
        std::int64_t number = value.count();
        raw(&number, sizeof number);
        // Times of a mission are within 136 years of 1970; sums of others would overflow.
        constexpr std::chrono::duration<Rep, Period> Most = std::chrono::seconds(1LL << 32);
        if (number > Most.count() || number < -Most.count()) {
            m_ok = false;
        } else if constexpr (!Writing) {
            value = std::chrono::duration<Rep, Period>(number);
        }
    }
    template <class Clock, class Duration>
    void one(std::chrono::time_point<Clock, Duration>& value) {
        Duration since = value.time_since_epoch();
        one(since);
        if constexpr (!Writing) value = std::chrono::time_point<Clock, Duration>(since);
    }

    void one(std::string& value) {
        const std::size_t size = count(value.size());
        if constexpr (!Writing) value.resize(size);
        raw(value.data(), size);
    }

    template <int Rows, int Columns>
    void one(Eigen::Matrix<double, Rows, Columns>& value) {
        for (double& number : value.reshaped()) raw(&number, sizeof number);
    }
    void one(Eigen::Quaterniond& value) { one(value.coeffs()); }
    void one(Eigen::Isometry3d& value) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) raw(&value.matrix()(row, column), sizeof(double));
        }
    }

    template <class T>
    void one(std::optional<T>& value) {
        bool there = value.has_value();
        one(there);
        if (!there || !m_ok) {
            if constexpr (!Writing) value.reset();
            return;
        }
        if constexpr (!Writing) value.emplace();
        one(*value);
    }

    template <class T>
    void one(std::shared_ptr<const T>& value) {
        std::optional<T> content;
        if (value) content = *value;
        one(content);
        if constexpr (!Writing) value = content ? std::make_shared<const T>(std::move(*content)) : nullptr;
    }

    template <class T>
    void one(std::vector<T>& values) {
        const std::size_t size = count(values.size());
        if constexpr (Writing) {
            for (T& value : values) one(value);
        } else {
            for (std::size_t i = 0; i < size && m_ok; ++i) one(values.emplace_back());
        }
    }

    template <class Key, class Value>
    void one(std::map<Key, Value>& values) {
        const std::size_t size = count(values.size());
        if constexpr (Writing) {
            for (auto& [key, value] : values) {
                Key copy = key;
                (*this)(copy, value);
            }
        } else {
            for (std::size_t i = 0; i < size && m_ok; ++i) {
                Key key{};
                one(key);
                const auto [place, fresh] = values.try_emplace(std::move(key));
                if (!fresh) m_ok = false;
                one(place->second);
            }
        }
    }

    template <class A, class B>
    void one(std::pair<A, B>& value) {
        (*this)(value.first, value.second);
    }
    template <class... T>
    void one(std::tuple<T...>& value) {
        std::apply([this](auto&... parts) { (*this)(parts...); }, value);
    }

    template <class... T>
    void one(std::variant<T...>& value) {
        auto index = static_cast<std::uint8_t>(value.index());
        raw(&index, 1);
        if constexpr (!Writing) {
            if (!emplace(value, index, std::index_sequence_for<T...>{})) m_ok = false;
        }
        if (m_ok) std::visit([this](auto& content) { one(content); }, value);
    }
    template <class Variant, std::size_t... Index>
    static bool emplace(Variant& value, std::size_t wanted, std::index_sequence<Index...>) {
        return ((wanted == Index && (value.template emplace<Index>(), true)) || ...);
    }

    template <class T>
    requires requires(Archive& archive, T& value) { describe(archive, value); }
    void one(T& value) { describe(*this, value); }

    std::vector<std::byte> m_bytes;     // written
    std::span<const std::byte> m_rest;  // to be read
    bool m_ok = true;
    std::size_t m_unpacked = 0;
    std::uint32_t m_version = 0;
};

}  // namespace leitstand
