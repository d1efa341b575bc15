#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace leitstand::detail {

/// One field of all points of a cloud. All its values are known to be within the cloud's data.
struct CloudColumn {
    const std::byte* data = nullptr;         ///< value of the first point; null: there is no such field
    std::size_t rows = 0, columns = 0;       ///< size of the cloud
    std::size_t pointStep = 0, rowStep = 0;  ///< [bytes]
    unsigned datatype = 0;                   ///< datatype of sensor_msgs/msg/PointField, 1 to 8
    bool swap = false;                       ///< whether values are in the other byte order

    explicit operator bool() const { return data != nullptr; }
};

template <class T>
T cloudValue(const std::byte* from, bool swap) {
    std::byte bytes[sizeof(T)];
    std::memcpy(bytes, from, sizeof(T));
    if (swap) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

/// Calls @p use(index of the point, value) for all points. Values must be of type T.
template <class T, class Use>
void forEachValueOf(const CloudColumn& column, Use use) {
    std::size_t index = 0;
    for (std::size_t row = 0; row < column.rows; ++row) {
        const std::byte* from = column.data + row * column.rowStep;
        for (std::size_t i = 0; i < column.columns; ++i, from += column.pointStep) {
            use(index++, cloudValue<T>(from, column.swap));
        }
    }
}

/// Calls @p use as above, for any type of PointField (INT8 to FLOAT64).
template <class Use>
void forEachValue(const CloudColumn& column, Use use) {
    switch (column.datatype) {
        case 1:
            return forEachValueOf<std::int8_t>(column, use);
        case 2:
            return forEachValueOf<std::uint8_t>(column, use);
        case 3:
            return forEachValueOf<std::int16_t>(column, use);
        case 4:
            return forEachValueOf<std::uint16_t>(column, use);
        case 5:
            return forEachValueOf<std::int32_t>(column, use);
        case 6:
            return forEachValueOf<std::uint32_t>(column, use);
        case 7:
            return forEachValueOf<float>(column, use);
        case 8:
            return forEachValueOf<double>(column, use);
        default:
            return;
    }
}

}  // namespace leitstand::detail
