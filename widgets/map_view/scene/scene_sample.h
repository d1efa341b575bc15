#pragma once

#include <cstddef>
#include <vector>

#include "widgets/map_view/scene/points/drawn_points.h"

namespace leitstand {

/// A fair sample of the points of many scans.
struct SceneSample {
    DrawnPointsPtr points;  ///< in the map's frame; every beginning of them is a fair sample, too
    /// The share of each scan's shown points that is in it, which are the first of each.
    double share = 1.0;
};

/// Of the @p scans and @p ghosts that are visible and made ready, about @p most points in all. A scan that is
/// drawn by itself costs as much as thousands of points, and a map has a thousand of them.
[[nodiscard]] SceneSample sampleOf(const std::vector<SceneScan>& scans, std::size_t most,
                                   const std::vector<SceneScan>& ghosts = {});

}  // namespace leitstand
