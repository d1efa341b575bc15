#include "core/io/clouds/detail/cloud_layout.h"

#include <algorithm>
#include <utility>

#include "core/io/detail/numbers.h"

namespace leitstand::detail {

std::size_t sizeOf(Scalar scalar) {
    switch (scalar) {
        case Scalar::Int8:
        case Scalar::UInt8:
            return 1;
        case Scalar::Int16:
        case Scalar::UInt16:
            return 2;
        case Scalar::Int32:
        case Scalar::UInt32:
        case Scalar::Float32:
            return 4;
        case Scalar::Int64:
        case Scalar::UInt64:
        case Scalar::Float64:
            return 8;
    }
    return 0;
}

bool CloudLayout::add(std::string name, Scalar type, std::size_t count) {
    if (count > (MaxRecordSize - m_recordSize) / sizeOf(type)) return false;
    m_fields.push_back({lowerCase(name), type, count, m_recordSize, m_columns});
    m_recordSize += count * sizeOf(type);
    m_columns += count;
    return true;
}

bool CloudLayout::hasPoints() const {
    return find({"x"}) != nullptr && find({"y"}) != nullptr && find({"z"}) != nullptr;
}

const CloudField* CloudLayout::find(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) {
        const auto found = std::find_if(m_fields.begin(), m_fields.end(), [&](const CloudField& field) {
            return field.name == name && field.count == 1;
        });
        if (found != m_fields.end()) return &*found;
    }
    return nullptr;
}

const CloudField* CloudLayout::intensity() const {
    return find({"intensity", "reflectance", "scalar_intensity", "scalar_reflectance"});
}

const CloudField* CloudLayout::label() const {
    return find({"label", "scalar_label"});
}

}  // namespace leitstand::detail
