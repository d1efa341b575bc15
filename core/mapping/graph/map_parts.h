#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/base/pose.h"

namespace leitstand {

struct Link;

/// Finds which key scans of a map are connected by active links. Connected scans are one part of the map; a
/// scan to which no active link leads is a part of its own. The relative pose of two parts is unknown.
class MapParts {
public:
    explicit MapParts(std::span<const Link> links);
    /// Returns the lowest id of the scans that are connected with @p scan, itself included.
    [[nodiscard]] std::uint64_t lowest(std::uint64_t scan) const;

private:
    std::map<std::uint64_t, std::uint64_t> m_towards;  ///< from a scan's id to a lower one of the same part
};

/// Returns whether a key scan begins a part of a map: it was registered against no scan, and no doubt
/// explains why. @p matched: id of the scan that it was registered against; 0: none. @p doubts: bits of
/// ScanDoubt; Guessed does not count.
[[nodiscard]] bool beginsPart(std::uint64_t matched, std::uint8_t doubts);

/// A key scan, and the part of the map that it belongs to.
struct ScanInPart {
    std::uint64_t id = 0;
    std::uint64_t matched = 0;  ///< id of the nearest scan that it was registered against; 0: none
    bool begins = false;        ///< beginsPart()
    Pose enteredAt = Pose::Identity();
    /// Id of the scan with which the part begins; the pose of this part relative to the map's first part is
    /// unknown. 0: the scan is of the first part, which begins at the map's origin.
    std::uint64_t part = 0;
};

/// Returns the ids of active loop links (LinkKind::Loop) whose scans are connected by nothing but such links,
/// and belong to different parts. The link that had joined these parts was taken back. @p scans, by rising
/// id, show where parts begin.
[[nodiscard]] std::set<std::uint64_t> unheldLoops(std::span<const Link> links,
                                                  std::span<const ScanInPart> scans);

/// Sets ScanInPart::part of @p scans, which are by rising id. It is the part that begins with the lowest
/// connected scan in @p parts. If no part begins there, a scan has the part of the scan that it was matched
/// with. Without that one, its part stays as it is.
void findParts(std::vector<ScanInPart>& scans, const MapParts& parts);

}  // namespace leitstand
