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

/// What a person states about two scans of a row. `from` and `to` are their places in the row, from 0.
struct GivenLink {
    std::size_t from = 0, to = 0;
    std::optional<Pose> toInFrom;  ///< roughly; empty: they see different places, even if these look alike
};

/// Two places of a row of scans that look the same.
struct SamePlace {
    std::size_t from = 0, to = 0;  ///< places in the row
    double shift = 0.0;            ///< how far the map was off there [m]
    std::uint64_t link = 0;        ///< id of its first link
};

/// A row of registered scans with closed loops.
struct ClosedMap {
    std::vector<Pose> poses;              ///< of the scans, in the first one's frame
    std::vector<SamePlace> closed;        ///< one for each time that the path came back
    std::vector<SamePlace> contradicted;  ///< closed at first, then left out: the rest contradicts them
    std::size_t unused = 0;         ///< number of given links that are not used: a scan has too few points
    std::vector<SamePlace> unsure;  ///< places shifted farther than is likely after such a path: not closed
    Relaxation relaxation;
};

/// Registers the scans of @p map in their order, each against those near it, starting from its pose relative
/// to the scan before. Closes loops where two places agree, and relaxes the result. @p given takes priority
/// over what is found. Error: what is wrong with @p given. Cancelled: ClosedMap::poses is empty.
[[nodiscard]] Result<ClosedMap> closeLoops(const Map& map, std::span<const GivenLink> given,
                                           const LiveSettings& settings = {},
                                           const RelaxationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
