#pragma once

#include <optional>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/places/sought_place.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// Moves the part of the map that has the scan of @p sought by @p correction, and returns whether it then
/// stands in the free space of @p rest. A new pose in the map is @p correction times the old pose.
/// SoughtPlace::elsewhere must be set; otherwise only scans of SoughtPlace::lately are compared. Cancelled:
/// true.
[[nodiscard]] bool contradictsPart(const SoughtPlace& sought, const LiveMap& rest, const Pose& correction,
                                   const Progress& progress = {});

/// Returns where the scan of @p sought was taken, as the earlier part of the map shows. It must be the only
/// place that looks like the scan. If recent scans are moved along with it, they must hardly stand in the
/// free space of earlier scans. Empty: no certain place, or cancelled. One scan cannot distinguish a new
/// place from a mapped place that looks the same, so a loop needs several scans that agree.
[[nodiscard]] std::optional<Pose> recognise(const SoughtPlace& sought, const LiveSettings& settings,
                                            const RelocalisationSettings& how = {},
                                            const Progress& progress = {});

}  // namespace leitstand
