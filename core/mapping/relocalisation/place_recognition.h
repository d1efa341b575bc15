#pragma once

#include <optional>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/sought_place.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// Returns whether the part of the map that holds @p sought, moved by @p correction, stands where @p rest
/// looked through. Cancelled: true.
[[nodiscard]] bool contradictsPart(const SoughtPlace& sought, const LiveMap& rest, const Pose& correction,
                                   const Progress& progress = {});

/// Returns where @p sought was taken, judged by the earlier part of the map. It is the only place that looks
/// like it. No recent scan, moved along with it, stands in what earlier ones looked through. Empty: no
/// certain place, or cancelled. One scan cannot distinguish a new place from a mapped one that looks the
/// same. A loop needs several that agree.
[[nodiscard]] std::optional<Pose> recognise(const SoughtPlace& sought, const LiveSettings& settings,
                                            const RelocalisationSettings& how = {},
                                            const Progress& progress = {});

}  // namespace leitstand
