#pragma once

#include <cstddef>
#include <vector>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// A fair sample of the points of many scans.
struct SceneSample {
    /// As one scan, in the map's frame; every beginning of what it shows is a fair sample, too.
    SceneScan scan;
    /// The share of each scan's shown points that is in it, which are the first of each.
    double share = 1.0;
};

/// Of the @p scans that are visible and made ready, about @p most points in all. A scan that is drawn by
/// itself costs as much as thousands of points, and a map has a thousand of them.
[[nodiscard]] SceneSample sampleOf(const std::vector<SceneScan>& scans, std::size_t most);

}  // namespace leitstand
