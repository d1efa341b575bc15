#include "core/mission/state/checkpoint/archive.h"

#include <cstring>

namespace leitstand {

void append(std::vector<std::byte>& to, const void* bytes, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(bytes);
    to.insert(to.end(), begin, begin + size);
}

bool extract(std::span<const std::byte>& from, void* into, std::size_t size) {
    if (size > from.size()) return false;
    if (size != 0) std::memcpy(into, from.data(), size);
    from = from.subspan(size);
    return true;
}

}  // namespace leitstand
