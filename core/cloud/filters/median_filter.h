#pragma once

#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Settings of the paper's median and reduction filter.
struct MedianFilterSettings {
    /// If a range differs by more than this from the median of 7 (itself and 3 on each side), it is replaced
    /// by the median [m].
    double outlier = 0.20;
    /// Neighbours nearer than this are joined [m]; 0.05 keeps only a fifth of half-degree scans.
    double joinDistance = 0.08;
    double longestRun = 0.20;  ///< largest distance of a point in a run from the run's first point [m]
    double minRange = 0.4, maxRange = 30.0;  ///< nearer and farther points are left out [m]
};

/// The paper's median and reduction filter for organised scans (section 2.2; Surmann, Nuechter & Hertzberg
/// 2003). Along each raw scan, an outlier is replaced by the median of 7 ranges with its own in the middle.
/// Then each run of close points becomes one point: their mean, with the most common label, the mean normal,
/// and their number as weight. Runs of consecutive raw scans are joined in the same way, so near surfaces are
/// thinned in both directions. About a tenth of a scan remains. @p normals: empty, or one per point of the
/// scan. From an unorganised scan, only points out of range are removed.
[[nodiscard]] PointCloud medianReduced(const Scan& scan, std::span<const Eigen::Vector3f> normals,
                                       const MedianFilterSettings& settings = {});

/// Returns the ranges along a raw scan with outliers replaced: the first step of medianReduced(). Neighbours
/// without an echo (NaN) are ignored. @p outlier: see MedianFilterSettings [m].
[[nodiscard]] std::vector<float> medianFilteredRanges(std::span<const float> ranges, double outlier);

}  // namespace leitstand
