#pragma once

#include <span>

#include "core/scan/scan.h"

namespace leitstand {

/// Settings of the paper's median and reduction filter.
struct MedianFilterSettings {
    double outlier = 0.20;  ///< a range farther than this from the median of its 7 neighbours becomes it [m]
    double joinDistance = 0.05;  ///< runs of points closer together than this become one point [m]
    double minRange = 0.4, maxRange = 30.0;  ///< other points are left out [m]
};

/// The paper's median and reduction filter (section 2.2, after Surmann, Nuechter & Hertzberg 2003) along the
/// raw scans of an organised @p scan: about a tenth of the points is left. @p normals: empty, or one a point
/// of the scan. An unorganised scan is only limited to its range.
[[nodiscard]] PointCloud medianReduced(const Scan& scan, std::span<const Eigen::Vector3f> normals,
                                       const MedianFilterSettings& settings = {});

}  // namespace leitstand
