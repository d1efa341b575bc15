#include "transport/cdr/cdr_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "transport/cdr/encapsulation.h"

namespace leitstand {
namespace {

constexpr std::size_t MostStructures = 100'000;
constexpr std::size_t MostPadding = 7;  // after the last field, from senders that round buffers up

}  // namespace

CdrReader::CdrReader(std::span<const std::byte> sample) {
    if (sample.size() < EncapsulationSize) {
        fail(fmt::format("expected an encapsulation header of 4 bytes, found {}", sample.size()));
        return;
    }
    const auto first = std::to_integer<int>(sample[0]), second = std::to_integer<int>(sample[1]);
    if (first != 0 || second > 1) {
        fail(fmt::format("expected plain XCDR1 (00 00 or 00 01), found {:02x} {:02x}", first, second));
        return;
    }
    m_swap = (second == 1) != (std::endian::native == std::endian::little);
    m_body = sample.subspan(EncapsulationSize);
}

void CdrReader::fail(std::string text) {
    if (m_error.empty()) m_error = std::move(text);
}

const std::byte* CdrReader::take(const char* field, std::size_t alignment, std::size_t size) {
    if (!ok()) return nullptr;
    const std::size_t begin = (m_at + alignment - 1) / alignment * alignment;
    if (begin > m_body.size() || size > m_body.size() - begin) {
        fail(fmt::format("{}: expected {} bytes at {}, the sample ends at {}", field, size, begin,
                         m_body.size()));
        return nullptr;
    }
    m_at = begin + size;
    return m_body.data() + begin;
}

std::size_t CdrReader::readCount(const char* field, std::size_t leastSize) {
    std::uint32_t count = 0;
    read(field, count);
    if (!ok()) return 0;
    if (count > (m_body.size() - m_at) / leastSize) {
        fail(fmt::format("{}: {} elements of at least {} bytes do not fit into the {} bytes left", field,
                         count, leastSize, m_body.size() - m_at));
        return 0;
    }
    return count;
}

std::size_t CdrReader::readStructureCount(const char* field, std::size_t leastSize) {
    const std::size_t count = readCount(field, leastSize);
    if (count <= MostStructures) return count;
    fail(fmt::format("{}: expected at most {} elements, found {}", field, MostStructures, count));
    return 0;
}

void CdrReader::read(const char* field, bool& to) {
    std::uint8_t value = 0;
    read(field, value);
    if (value > 1) return fail(fmt::format("{}: expected a boolean, found {}", field, value));
    to = value == 1;
}

void CdrReader::read(const char* field, std::string& to) {
    const std::size_t size = readCount(field, 1);
    to.clear();
    if (size == 0) return;  // some senders omit even the terminator of an empty text
    const std::byte* from = take(field, 1, size);
    if (from == nullptr) return;
    const auto* text = reinterpret_cast<const char*>(from);
    if (std::find(text, text + size, '\0') != text + size - 1) {
        return fail(
            fmt::format("{}: expected a text of {} bytes that ends with its first zero byte", field, size));
    }
    to.assign(text, size - 1);
}

void CdrReader::read(const char* field, std::span<const std::byte>& to) {
    const std::size_t size = readCount(field, 1);
    to = {};
    if (size == 0) return;
    if (const std::byte* from = take(field, 1, size)) to = {from, size};
}

void CdrReader::read(const char* field, std::vector<std::string>& to) {
    to.resize(readStructureCount(field, sizeof(std::uint32_t)));
    for (std::string& text : to) {
        if (!ok()) return;
        read(field, text);
    }
}

Result<void> CdrReader::finish() {
    if (ok() && m_body.size() - m_at > MostPadding) {
        fail(fmt::format("expected the end at {}, {} bytes are left over", m_at, m_body.size() - m_at));
    }
    if (!ok()) return Error{m_error};
    return {};
}

void CdrReader::swapBytes(std::byte* values, std::size_t size, std::size_t count) {
    if (size == 1) return;
    for (std::size_t i = 0; i < count; ++i) std::reverse(values + i * size, values + (i + 1) * size);
}

}  // namespace leitstand
