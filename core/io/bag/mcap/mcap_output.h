#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/bag/mcap/mcap_records.h"

namespace leitstand::detail {

// Fields of MCAP records (mcap_records.h), appended to the bytes @p to.

inline void addNumber(std::string& to, std::uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) to += static_cast<char>(number >> (8 * i) & 0xFFU);
}
inline void add16(std::string& to, std::uint16_t number) {
    addNumber(to, number, 2);
}
inline void add32(std::string& to, std::uint32_t number) {
    addNumber(to, number, 4);
}
inline void add64(std::string& to, std::uint64_t number) {
    addNumber(to, number, 8);
}
/// A text, or bytes, behind their length.
inline void addText(std::string& to, std::string_view text) {
    add32(to, static_cast<std::uint32_t>(text.size()));
    to += text;
}
/// A whole record.
inline void addRecord(std::string& to, McapOp op, std::string_view content) {
    to += static_cast<char>(op);
    add64(to, content.size());
    to += content;
}

}  // namespace leitstand::detail
