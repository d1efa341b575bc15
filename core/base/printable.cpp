#include "core/base/printable.h"

#include <cstdint>

#include <fmt/format.h>

namespace leitstand {
namespace {

/// The next character of a text and how many bytes it takes; code -1: one byte that is no UTF-8.
struct Character {
    std::int32_t code = -1;
    std::size_t bytes = 1;
};

Character characterAt(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at);
    if (first < 0x80) return {static_cast<std::int32_t>(first), 1};
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || at + bytes > text.size()) return {};
    std::uint32_t code = first & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(at + i) & 0xc0U) != 0x80U) return {};
        code = (code << 6U) | (byte(at + i) & 0x3fU);
    }
    // Overlong, half of a surrogate pair of UTF-16, or above the last code point.
    const bool wrong = (bytes == 3 && code < 0x800) || (bytes == 4 && (code < 0x10000 || code > 0x10ffff)) ||
                       (code >= 0xd800 && code <= 0xdfff);
    if (wrong) return {};
    return {static_cast<std::int32_t>(code), bytes};
}

/// Whether a terminal obeys the character instead of showing it.
bool isControl(std::int32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x061c ||
           (code >= 0x200e && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069) || code == 0xfeff || (code >= 0xe0000 && code <= 0xe007f);
}

std::string escaped(std::int32_t code) {
    switch (code) {
        case '\n':
            return "\\n";
        case '\r':
            return "\\r";
        case '\t':
            return "\\t";
        default:
            return code < 0x80      ? fmt::format("\\x{:02x}", code)
                   : code < 0x10000 ? fmt::format("\\u{:04x}", code)
                                    : fmt::format("\\U{:08x}", code);
    }
}

std::string escapedText(std::string_view text, bool lines) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const Character next = characterAt(text, at);
        if (next.code < 0) {
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[at]));
        } else if (isControl(next.code) && !(lines && next.code == '\n')) {
            out += escaped(next.code);
        } else {
            out += text.substr(at, next.bytes);
        }
        at += next.bytes;
    }
    return out;
}

}  // namespace

std::string printable(std::string_view text) {
    return escapedText(text, false);
}

std::string printableLines(std::string_view text) {
    return escapedText(text, true);
}

std::string printableJson(std::string_view json) {
    std::string out;
    out.reserve(json.size());
    for (std::size_t at = 0; at < json.size();) {
        const Character next = characterAt(json, at);
        if (next.code < 0x7f || !isControl(next.code)) {
            out += json.substr(at, next.bytes);
        } else if (next.code < 0x10000) {
            out += fmt::format("\\u{:04x}", next.code);
        } else {  // as a pair of UTF-16
            const std::int32_t rest = next.code - 0x10000;
            out += fmt::format("\\u{:04x}\\u{:04x}", 0xd800 + (rest >> 10), 0xdc00 + (rest & 0x3ff));
        }
        at += next.bytes;
    }
    return out;
}

}  // namespace leitstand
