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

/// What somebody says of two scans of a row, by their places in it.
struct GivenLink {
    std::size_t from = 0, to = 0;
    std::optional<Pose> toInFrom;  ///< roughly; empty: they do not see the same place, whatever it looks like
};

/// Two places of a row of scans that look the same.
struct SamePlace {
    std::size_t from = 0, to = 0;  ///< places in the row
    double shift = 0.0;            ///< by which the map was off there [m]
    std::uint64_t link = 0;        ///< id of the first link that says so
};

/// A row of registered scans whose loops are closed.
struct ClosedMap {
    std::vector<Pose> poses;              ///< of the scans, in the first one's frame
    std::vector<SamePlace> closed;        ///< one for each time that the way came back
    std::vector<SamePlace> contradicted;  ///< closed at first, left out since: the rest speaks against them
    std::size_t unused = 0;               ///< links by hand of scans that have too few points
    std::vector<SamePlace> unsure;        ///< farther off than a way of that length makes likely: not closed
    Relaxation relaxation;
};

/// Goes through @p map's scans in their order, each registered against those near it from where the map has
/// it relative to the one before, closes loops where two places agree, and relaxes what came of it. @p given
/// goes before what is found. An error names what is wrong with @p given. Cancelled: an empty row of poses.
[[nodiscard]] Result<ClosedMap> closeLoops(const Map& map, std::span<const GivenLink> given,
                                           const LiveSettings& settings = {},
                                           const RelaxationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
