#pragma once

#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Settings of the paper's median and reduction filter.
struct MedianFilterSettings {
    double outlier = 0.20;  ///< a range that is farther than this from the median of 7 (itself and 3 on each
                            ///< side) is replaced by that median [m]
    double joinDistance =
        0.08;  ///< neighbours nearer than this are joined (0.05 leaves a fifth of half-degree scans) [m]
    double longestRun = 0.20;                ///< longest distance of a run from its first point [m]
    double minRange = 0.4, maxRange = 30.0;  ///< points outside are left out [m]
};

/// The paper's median and reduction filter for organised scans (section 2.2; Surmann, Nuechter & Hertzberg
/// 2003). Along each raw scan an outlier is replaced by the median of 7 ranges, its own in the middle. Each
/// run of close points then becomes one point: their mean, with the commonest label, the mean normal and
/// their number as weight. Runs of successive raw scans are joined in the same way, so near surfaces are
/// thinned in both directions. About a tenth of a scan is left. @p normals: empty, or one a point of the
/// scan. Of an unorganised scan, only the points out of range are left out.
[[nodiscard]] PointCloud medianReduced(const Scan& scan, std::span<const Eigen::Vector3f> normals,
                                       const MedianFilterSettings& settings = {});

/// Returns the ranges along a raw scan with outliers replaced: the first step of medianReduced(). Neighbours
/// without an echo (NaN) do not count. @p outlier: see MedianFilterSettings [m].
[[nodiscard]] std::vector<float> medianFilteredRanges(std::span<const float> ranges, double outlier);

}  // namespace leitstand
