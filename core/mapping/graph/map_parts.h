#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/base/pose.h"
#include "core/event/scan_links.h"

namespace leitstand {

/// Which key scans of a map hang together by links: what no active link leads to is a part of its own, and
/// nobody knows how it lies to the others.
class MapParts {
public:
    explicit MapParts(std::span<const Link> links);
    /// The lowest id of the scans that hang together with @p scan, itself included.
    [[nodiscard]] std::uint64_t lowest(std::uint64_t scan) const;

private:
    std::map<std::uint64_t, std::uint64_t> m_towards;  ///< from scan to a lower one of its part
};

/// Whether a part of a map begins with a key scan that was registered against @p matched (0: nothing) and has
/// @p doubts, a set of ScanDoubt: nothing that was there before led to it.
[[nodiscard]] bool beginsPart(std::uint64_t matched, std::uint8_t doubts);

/// A key scan, and the part of the map that it is of.
struct ScanInPart {
    std::uint64_t id = 0;
    std::uint64_t matched = 0;  ///< id of the nearest scan that it was registered against; 0: none
    bool begins = false;        ///< beginsPart()
    Pose enteredAt = Pose::Identity();
    /// With which scan the part begins, where that has not met the map's first part, which begins at the
    /// map's origin; 0: it is of that.
    std::uint64_t part = 0;
};

/// Ids of active loops of @p links whose scans hang together by nothing else and are of different parts, by
/// where these begin among @p scans, which are by rising id: what had made the parts one was taken back
/// since.
[[nodiscard]] std::set<std::uint64_t> unheldLoops(std::span<const Link> links,
                                                  std::span<const ScanInPart> scans);

/// Puts the part of each of @p scans, which are by rising id, to what @p parts say; where they say nothing it
/// stays as it is.
void findParts(std::vector<ScanInPart>& scans, const MapParts& parts);

}  // namespace leitstand
