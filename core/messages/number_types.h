#pragma once

#include <cstdint>
#include <string_view>

namespace leitstand {

/// Calls @p take with a value of the C++ type of the number @p type, a MessageField::type whose
/// sizeOfNumber() is not 0.
template <class Take>
void withNumberType(std::string_view type, Take take) {
    if (type == "bool") return take(bool{});
    if (type == "int8") return take(std::int8_t{});
    if (type == "int16") return take(std::int16_t{});
    if (type == "uint16") return take(std::uint16_t{});
    if (type == "int32") return take(std::int32_t{});
    if (type == "uint32") return take(std::uint32_t{});
    if (type == "int64") return take(std::int64_t{});
    if (type == "uint64") return take(std::uint64_t{});
    if (type == "float32") return take(float{});
    if (type == "float64") return take(double{});
    take(std::uint8_t{});  // uint8, byte, char
}

}  // namespace leitstand
