#include "core/mapping/graph/map_parts.h"

#include <algorithm>
#include <iterator>

#include "core/event/map_samples.h"
#include "core/event/scan_links.h"

namespace leitstand {
namespace {

/// Returns the one of @p scans, which are by rising id, with @p id; null: none.
const ScanInPart* scanWith(std::span<const ScanInPart> scans, std::uint64_t id) {
    const auto found =
        std::lower_bound(scans.begin(), scans.end(), id,
                         [](const ScanInPart& scan, std::uint64_t wanted) { return scan.id < wanted; });
    return found != scans.end() && found->id == id ? &*found : nullptr;
}

/// Returns ScanInPart::part of the part that begins with @p scan.
std::uint64_t partBeginningWith(const ScanInPart& scan) {
    constexpr double Aside = 1.0;  // the map's first part begins at its origin [m]
    return scan.enteredAt.translation().norm() > Aside ? scan.id : 0;
}

}  // namespace

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

std::set<std::uint64_t> unheldLoops(std::span<const Link> links, std::span<const ScanInPart> scans) {
    std::vector<Link> others;
    std::copy_if(links.begin(), links.end(), std::back_inserter(others),
                 [](const Link& link) { return link.kind != LinkKind::Loop; });
    if (others.size() == links.size()) return {};
    const MapParts parts(others);
    std::set<std::uint64_t> unheld;
    for (const Link& link : links) {
        if (!link.active || link.kind != LinkKind::Loop) continue;
        const ScanInPart* const from = scanWith(scans, parts.lowest(link.from));
        const ScanInPart* const to = scanWith(scans, parts.lowest(link.to));
        if (from == to || from == nullptr || to == nullptr || !from->begins || !to->begins) continue;
        if (partBeginningWith(*from) != partBeginningWith(*to)) unheld.insert(link.id);
    }
    return unheld;
}

void findParts(std::vector<ScanInPart>& scans, const MapParts& parts) {
    for (ScanInPart& scan : scans) {
        const ScanInPart* const beginning = scanWith(scans, parts.lowest(scan.id));
        if (beginning != nullptr && beginning->begins) {
            scan.part = partBeginningWith(*beginning);
        } else if (const ScanInPart* const matched = scanWith(scans, scan.matched)) {
            // Old missions, and scans that were decided on, have no links. A scan comes later than the one it
            // was matched with.
            scan.part = matched->part;
        }
    }
}

}  // namespace leitstand
