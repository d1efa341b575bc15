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
    /// Poses of key scans that agree, by id. Empty: the relative pose of the two parts is not known.
    std::map<std::uint64_t, Pose> scansInMap;
    std::size_t sought = 0;  ///< scans that were looked for
    std::size_t found = 0;   ///< of these, each on its own, whether they agree or not
};

/// Looks for some scans from all over the part @p part of @p map (LiveKeyScan::part) in its first part: for
/// maps that are complete. The two meet where at least LoopSettings::partsAgree scans agree, and twice as
/// many as agree on anything else. The whole part, moved there, must stand in little that the first part
/// looked through. Cancelled: nowhere.
[[nodiscard]] PartsMeeting meetingOf(const LiveMapPtr& map, std::uint64_t part, const LiveSettings& settings,
                                     const RelocalisationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
