#include "core/perception/pictures/content_hash.h"

#include <algorithm>
#include <cstring>

namespace leitstand {

std::uint64_t contentHash(std::span<const std::byte> bytes) {
    constexpr std::uint64_t Prime = 1099511628211ULL;
    std::uint64_t hash = 14695981039346656037ULL ^ bytes.size();
    while (!bytes.empty()) {
        std::uint64_t word = 0;
        const std::size_t count = std::min(bytes.size(), sizeof word);
        std::memcpy(&word, bytes.data(), count);
        hash = (hash ^ word) * Prime;
        hash ^= hash >> 32U;  // high bits of a word count as much as low ones
        bytes = bytes.subspan(count);
    }
    return hash;
}

}  // namespace leitstand
