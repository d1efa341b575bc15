#pragma once

#include <optional>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/places/sought_place.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// Returns whether the part of the map with the scan of @p sought, moved by @p correction, stands where
/// @p rest looked through. @p correction is put before poses in the map. SoughtPlace::elsewhere must be set;
/// without it, only scans of SoughtPlace::lately are compared. Cancelled: true.
[[nodiscard]] bool contradictsPart(const SoughtPlace& sought, const LiveMap& rest, const Pose& correction,
                                   const Progress& progress = {});

/// Returns where the scan of @p sought was taken, by the earlier part of the map. It must be the only place
/// that looks like the scan. Recent scans, moved along with it, may hardly stand in what earlier ones looked
/// through. Empty: no certain place, or cancelled. One scan cannot distinguish a new place from a mapped one
/// that looks the same. A loop needs several that agree.
[[nodiscard]] std::optional<Pose> recognise(const SoughtPlace& sought, const LiveSettings& settings,
                                            const RelocalisationSettings& how = {},
                                            const Progress& progress = {});

}  // namespace leitstand
