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

/// The result of looking for a part of a map in its first part.
struct PartsMeeting {
    /// Poses of the key scans that agree, by id, in the map as its first part lies. Empty: the relative pose
    /// of the two parts is not known.
    std::map<std::uint64_t, Pose> scansInMap;
    std::size_t sought = 0;  ///< scans that were looked for
    std::size_t found = 0;   ///< scans that were found, each on its own, whether or not they agree
};

/// Looks for scans from all over the part @p part of @p map (LiveKeyScan::part) in its first part: for maps
/// that are complete. The two parts meet where at least LoopSettings::partsAgree scans agree, and twice as
/// many as agree on anything else. The whole part, moved there, may also hardly stand where the first part
/// looked through. Cancelled: they do not meet.
[[nodiscard]] PartsMeeting meetingOf(const LiveMapPtr& map, std::uint64_t part, const LiveSettings& settings,
                                     const RelocalisationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
