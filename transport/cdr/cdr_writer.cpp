#include "transport/cdr/cdr_writer.h"

#include <algorithm>

#include "transport/cdr/encapsulation.h"

namespace leitstand {

CdrWriter::CdrWriter(std::endian order) : m_swap(order != std::endian::native) {
    m_bytes = {std::byte{0}, order == std::endian::little ? std::byte{1} : std::byte{0}, std::byte{0},
               std::byte{0}};
}

void CdrWriter::put(const void* values, std::size_t size, std::size_t count) {
    const std::size_t used = m_bytes.size() - EncapsulationSize;
    const std::size_t padding = (size - used % size) % size;
    const auto* from = static_cast<const std::byte*>(values);
    m_bytes.insert(m_bytes.end(), padding, std::byte{0});
    const auto begin = m_bytes.insert(m_bytes.end(), from, from + size * count);
    if (!m_swap || size == 1) return;
    for (auto value = begin; value != m_bytes.end(); value += static_cast<std::ptrdiff_t>(size)) {
        std::reverse(value, value + static_cast<std::ptrdiff_t>(size));
    }
}

void CdrWriter::write(const std::string& text) {
    write(static_cast<std::uint32_t>(text.size() + 1));
    put(text.c_str(), 1, text.size() + 1);
}

void CdrWriter::write(std::span<const std::byte> bytes) {
    write(static_cast<std::uint32_t>(bytes.size()));
    if (!bytes.empty()) put(bytes.data(), 1, bytes.size());
}

void CdrWriter::write(const std::vector<std::string>& texts) {
    write(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts) write(text);
}

}  // namespace leitstand
