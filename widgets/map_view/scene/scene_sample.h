#pragma once

#include <cstddef>
#include <vector>

#include "widgets/map_view/scene/points/drawn_points.h"

namespace leitstand {

/// A fair sample of the points of many scans.
struct SceneSample {
    DrawnPointsPtr points;  ///< in the map's frame [m]; any first part of them is a fair sample, too
    /// Share of each scan's shown points that is in the sample. The sample has the first points in the scan's
    /// random order.
    double share = 1.0;
};

/// Returns a sample of about @p most points from the @p scans and @p ghosts that are shown. It is used
/// because drawing a scan separately costs as much as thousands of points, and a map has a thousand scans.
[[nodiscard]] SceneSample sampleOf(const std::vector<SceneScan>& scans, std::size_t most,
                                   const std::vector<SceneScan>& ghosts = {});

}  // namespace leitstand
