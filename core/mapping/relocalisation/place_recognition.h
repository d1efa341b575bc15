#pragma once

#include <optional>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/sought_place.h"
#include "core/mapping/relocalisation/relocaliser.h"

namespace leitstand {

/// Whether the part of the map that @p sought is of, moved by @p correction, stands where @p rest looked
/// through. Cancelled: yes.
[[nodiscard]] bool contradictsPart(const SoughtPlace& sought, const LiveMap& rest, const Pose& correction,
                                   const Progress& progress = {});

/// Where @p sought was taken by what the map's earlier part shows: one place that looks as it does and where
/// no scan of lately, moved along with it, stands in what earlier ones looked through. Empty: nowhere for
/// sure, or cancelled. A place that is not mapped yet and looks as a mapped one cannot be told from it by one
/// scan: who closes a loop wants several that agree.
[[nodiscard]] std::optional<Pose> recognise(const SoughtPlace& sought, const LiveSettings& settings,
                                            const RelocalisationSettings& how = {},
                                            const Progress& progress = {});

}  // namespace leitstand
