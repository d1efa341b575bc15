#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// The result of searching the map's first part for another part.
struct PartsMeeting {
    /// Poses of the key scans that agree, by id, in the map's first part. Empty: the relative pose of the two
    /// parts is unknown.
    std::map<std::uint64_t, Pose> scansInMap;
    std::size_t sought = 0;  ///< number of scans that were looked for
    std::size_t found = 0;   ///< number of scans that were found, each by itself, whether or not they agree
};

/// Looks for scans of the part @p part of @p map (LiveKeyScan::part) in the map's first part. Scans are taken
/// from all over the part; the map must be complete. The two parts are joined if at least
/// LoopSettings::partsAgree scans agree, and twice as many as agree on anything else. The moved part must
/// also hardly stand in the free space of the first part. Cancelled: they are not joined.
[[nodiscard]] PartsMeeting meetingOf(const LiveMapPtr& map, std::uint64_t part, const LiveSettings& settings,
                                     const RelocalisationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
