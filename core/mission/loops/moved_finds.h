#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/base/pose.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// Returns the finds that would move by more than @p least [m] if key scans had the poses @p scansInMap.
/// Leaves out discarded finds.
[[nodiscard]] std::vector<FindKey> findsMovedBy(const MissionState& state,
                                                const std::map<std::uint64_t, Pose>& scansInMap,
                                                double least);

}  // namespace leitstand
