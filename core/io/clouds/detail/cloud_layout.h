#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace leitstand::detail {

/// Kinds of numbers in PCD and PLY files.
enum class Scalar : std::uint8_t {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64
};

[[nodiscard]] std::size_t sizeOf(Scalar scalar);  ///< size of a number of this kind [B]

/// A field of a point: one number, or several consecutive numbers.
struct CloudField {
    std::string name;
    Scalar type = Scalar::Float32;
    std::size_t count = 1;
    std::size_t offset = 0;  ///< from the first byte of the point [B]
    std::size_t column = 0;  ///< column of its first number in a line of text
};

/// The fields of a point in a PCD or PLY file.
class CloudLayout {
public:
    static constexpr std::size_t MaxRecordSize = 1 << 18;  ///< largest size of a point [B]

    /// Appends a field. Returns false when a point would exceed MaxRecordSize.
    [[nodiscard]] bool add(std::string name, Scalar type, std::size_t count = 1);

    [[nodiscard]] std::size_t recordSize() const { return m_recordSize; }  ///< size of a point [B]
    [[nodiscard]] std::size_t columns() const { return m_columns; }        ///< how many numbers a point has
    [[nodiscard]] bool hasPoints() const;  ///< whether there are fields x, y and z
    /// Returns the field that holds a single number and is called by one of @p names (lower case); null when
    /// there is none.
    [[nodiscard]] const CloudField* find(std::initializer_list<std::string_view> names) const;
    [[nodiscard]] const CloudField* intensity() const;
    [[nodiscard]] const CloudField* label() const;

private:
    std::vector<CloudField> m_fields;
    std::size_t m_recordSize = 0, m_columns = 0;
};

}  // namespace leitstand::detail
