#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/base/pose.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// Finds that are not discarded and would lie elsewhere by more than @p least [m] if key scans came to stand
/// where @p scansInMap has them.
[[nodiscard]] std::vector<FindKey> findsMovedBy(const MissionState& state,
                                                const std::map<std::uint64_t, Pose>& scansInMap,
                                                double least);

}  // namespace leitstand
