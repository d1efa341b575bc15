#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// Where a scan of one part of a map was taken in the rest of it.
struct MeetingPlace {
    std::uint64_t scan = 0;  ///< id
    Pose scanInMap = Pose::Identity();
};

/// What came of looking for a part of a map in the rest of it.
struct PartsMeeting {
    std::vector<MeetingPlace> places;  ///< they agree; empty: it is not known how the two lie to each other
    std::size_t sought = 0;            ///< scans that were looked for
    std::size_t found = 0;             ///< of these, each by itself, whether they agree or not
};

/// Looks for scans of the part @p part of @p map, some all over it, in the rest of the map: for maps that are
/// whole already. The two meet where at least LoopSettings::partsAgree of them agree, twice as many as agree
/// on anything else, and where all of the part, moved there, stands in little that the rest looked through.
/// Cancelled: nowhere.
[[nodiscard]] PartsMeeting meetingOf(const LiveMapPtr& map, std::uint64_t part, const LiveSettings& settings,
                                     const RelocalisationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
