#include "widgets/models/live/picture_age.h"

#include <chrono>
#include <cstring>

namespace leitstand {

std::uint64_t contentHash(std::span<const std::byte> bytes) {
    constexpr std::uint64_t Prime = 1099511628211ULL;
    std::uint64_t hash = 14695981039346656037ULL ^ bytes.size();
    while (!bytes.empty()) {
        std::uint64_t word = 0;
        const std::size_t count = bytes.size() < sizeof word ? bytes.size() : sizeof word;
        std::memcpy(&word, bytes.data(), count);
        hash = (hash ^ word) * Prime;
        hash ^= hash >> 32;  // high bits of a word count as much as low ones
        bytes = bytes.subspan(count);
    }
    return hash;
}

void PictureAge::arrived(std::uint64_t content, SteadyTime now) {
    if (m_content != content) m_change = now;
    m_content = content;
    m_arrival = now;
}

DataAge PictureAge::at(SteadyTime now) const {
    if (!m_content) return {};
    const auto since = [now](SteadyTime then) { return std::chrono::duration<double>(now - then).count(); };
    return {.arrival = since(m_arrival), .content = since(m_change)};
}

}  // namespace leitstand
