#include "core/mapping/graph/map_parts.h"

#include <algorithm>

#include "core/event/map_samples.h"

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

bool beginsPart(std::uint64_t matched, std::uint8_t doubts) {
    return matched == 0 && (doubts & ~static_cast<std::uint8_t>(ScanDoubt::Guessed)) == 0;
}

void findParts(std::vector<ScanInPart>& scans, const MapParts& parts) {
    constexpr double Aside = 1.0;  // the map's first part begins at its origin [m]
    const auto find = [&scans](std::uint64_t id) -> const ScanInPart* {
        const auto found =
            std::lower_bound(scans.begin(), scans.end(), id,
                             [](const ScanInPart& scan, std::uint64_t wanted) { return scan.id < wanted; });
        return found != scans.end() && found->id == id ? &*found : nullptr;
    };
    for (ScanInPart& scan : scans) {
        const ScanInPart* const beginning = find(parts.lowest(scan.id));
        if (beginning != nullptr && beginning->begins) {
            scan.part = beginning->enteredAt.translation().norm() > Aside ? beginning->id : 0;
        } else if (const ScanInPart* const matched = find(scan.matched)) {
            // Links of old missions, and of scans that were decided on, are missing. It comes later than that
            // one.
            scan.part = matched->part;
        }
    }
}

}  // namespace leitstand
