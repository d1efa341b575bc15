#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/map.h"
#include "core/mapping/relaxation/relaxation.h"

namespace leitstand {

/// What a person knows about two scans of a sequence. `from` and `to` are their indices in the sequence.
struct GivenLink {
    std::size_t from = 0, to = 0;
    /// Rough relative pose; empty: they see different places, even if these look alike.
    std::optional<Pose> toInFrom;
};

/// Two scans of a sequence that see the same place.
struct SamePlace {
    std::size_t from = 0, to = 0;  ///< indices in the sequence
    double shift = 0.0;            ///< error of the map there before the loop closed [m]
    std::uint64_t link = 0;        ///< id of the loop's first link
};

/// A sequence of registered scans with closed loops.
struct ClosedMap {
    std::vector<Pose> poses;        ///< poses of the scans in the frame of the first scan
    std::vector<SamePlace> closed;  ///< one for each time that the path returned to a place
    /// Closed at first and then removed, because the other links contradict them.
    std::vector<SamePlace> contradicted;
    std::size_t unused = 0;  ///< number of given links that are not used, because a scan has too few points
    /// Not closed, because the shift is larger than is likely after such a path.
    std::vector<SamePlace> unsure;
    Relaxation relaxation;
};

/// Registers the scans of @p map in their order. Each is registered against the scans near it, and starts
/// from its pose relative to the previous scan. Closes loops where two places agree, and relaxes the result.
/// Links in @p given have priority over links that are found. Error: what is wrong with @p given. Cancelled:
/// ClosedMap::poses is empty.
[[nodiscard]] Result<ClosedMap> closeLoops(const Map& map, std::span<const GivenLink> given,
                                           const LiveSettings& settings = {},
                                           const RelaxationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
