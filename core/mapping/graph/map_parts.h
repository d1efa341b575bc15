#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "core/base/pose.h"

namespace leitstand {

struct Link;

/// Finds which key scans of a map are connected by active links. Connected scans form one part of the map. A
/// scan without active links is a part by itself. The relative pose of two parts is unknown.
class MapParts {
public:
    explicit MapParts(std::span<const Link> links);
    /// Returns the lowest id among @p scan and the scans that are connected with it.
    [[nodiscard]] std::uint64_t lowest(std::uint64_t scan) const;

private:
    /// From the id of a scan to a lower id in the same part.
    std::map<std::uint64_t, std::uint64_t> m_towards;
};

/// Returns whether a key scan begins a part of a map. It does if it was registered against no scan, and no
/// doubt explains this. @p matched: id of the scan that it was registered against; 0: none. @p doubts: bits
/// of ScanDoubt; Guessed is ignored.
[[nodiscard]] bool beginsPart(std::uint64_t matched, std::uint8_t doubts);

/// A key scan and its part of the map.
struct ScanInPart {
    std::uint64_t id = 0;
    std::uint64_t matched = 0;  ///< id of the nearest scan that this scan was registered against; 0: none
    bool begins = false;        ///< result of beginsPart()
    Pose enteredAt = Pose::Identity();
    /// Id of the scan that begins the part. The pose of this part relative to the map's first part is
    /// unknown. 0: the first part, which begins at the map's origin.
    std::uint64_t part = 0;
};

/// Returns the ids of active loop links (LinkKind::Loop) whose scans belong to different parts and are
/// connected only by such links. The link that once joined these parts was removed. @p scans, by rising id,
/// say where parts begin.
[[nodiscard]] std::set<std::uint64_t> unheldLoops(std::span<const Link> links,
                                                  std::span<const ScanInPart> scans);

/// Sets ScanInPart::part of all @p scans, which are sorted by rising id. A scan belongs to the part that
/// begins with the lowest scan connected with it (@p parts). If no part begins there, it belongs to the part
/// of the scan that it was matched with. If that scan is missing, its part does not change.
void findParts(std::vector<ScanInPart>& scans, const MapParts& parts);

}  // namespace leitstand
