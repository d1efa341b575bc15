#include "core/mapping/graph/map_parts.h"

#include <algorithm>

namespace leitstand {

MapParts::MapParts(std::span<const Link> links) {
    for (const Link& link : links) {
        if (!link.active) continue;
        const std::uint64_t a = lowest(link.from), b = lowest(link.to), low = std::min(a, b);
        if (a != b) m_towards[std::max(a, b)] = low;
        // Both ends lead on to the lowest in one step next time.
        for (const std::uint64_t end : {link.from, link.to}) {
            if (end != low) m_towards[end] = low;
        }
    }
}

std::uint64_t MapParts::lowest(std::uint64_t scan) const {
    for (auto next = m_towards.find(scan); next != m_towards.end(); next = m_towards.find(scan))
        scan = next->second;
    return scan;
}

}  // namespace leitstand
