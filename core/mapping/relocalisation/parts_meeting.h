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

/// What came of looking for a part of a map in its first one.
struct PartsMeeting {
    /// By key scan: they agree. Empty: it is not known how the two lie to each other.
    std::map<std::uint64_t, Pose> scansInMap;
    std::size_t sought = 0;  ///< scans that were looked for
    std::size_t found = 0;   ///< of these, each by itself, whether they agree or not
};

/// Looks for scans of the part @p part of @p map (LiveKeyScan::part), some all over it, in its first part:
/// for maps that are whole already. The two meet where at least LoopSettings::partsAgree of them agree, twice
/// as many as agree on anything else, and where all of the part, moved there, stands in little that the first
/// one looked through. Cancelled: nowhere.
[[nodiscard]] PartsMeeting meetingOf(const LiveMapPtr& map, std::uint64_t part, const LiveSettings& settings,
                                     const RelocalisationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
