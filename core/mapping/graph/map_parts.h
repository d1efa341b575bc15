#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/base/pose.h"

namespace leitstand {

struct Link;

/// Finds which key scans of a map are connected by links. Scans that no active link leads to are a part of
/// their own. Its pose relative to the others is unknown.
class MapParts {
public:
    explicit MapParts(std::span<const Link> links);
    /// Returns the lowest id of the scans that are connected with @p scan, itself included.
    [[nodiscard]] std::uint64_t lowest(std::uint64_t scan) const;

private:
    std::map<std::uint64_t, std::uint64_t> m_towards;  ///< from scan to a lower one of its part
};

/// Returns whether a key scan begins a part of a map: nothing before led to it. @p matched: scan it was
/// registered against (0: none). @p doubts: set of ScanDoubt.
[[nodiscard]] bool beginsPart(std::uint64_t matched, std::uint8_t doubts);

/// A key scan, and the part of the map that it belongs to.
struct ScanInPart {
    std::uint64_t id = 0;
    std::uint64_t matched = 0;  ///< id of the nearest scan that it was registered against; 0: none
    bool begins = false;        ///< beginsPart()
    Pose enteredAt = Pose::Identity();
    /// The scan with which the part begins, if it has not met the map's first part, which begins at the map's
    /// origin; 0: it is of the first part.
    std::uint64_t part = 0;
};

/// Returns ids of active loops of @p links whose scans nothing else connects. The scans are of different
/// parts, by where these begin among @p scans, which are by rising id. The link that had joined the parts was
/// taken back.
[[nodiscard]] std::set<std::uint64_t> unheldLoops(std::span<const Link> links,
                                                  std::span<const ScanInPart> scans);

/// Sets the part of each of @p scans, which are by rising id, from @p parts, or else from the scan it was
/// matched with. Without either it stays as it is.
void findParts(std::vector<ScanInPart>& scans, const MapParts& parts);

}  // namespace leitstand
