#include "core/cloud/filters/range_filter.h"

#include <cassert>

namespace leitstand {

PointCloud pointsInRange(const Scan& scan, std::span<const Eigen::Vector3f> normals, double minRange,
                         double maxRange) {
    assert(normals.empty() || normals.size() == scan.points.size());
    const bool labelled = !scan.labels.empty() && scan.labels.size() == scan.points.size();
    PointCloud cloud;
    cloud.points.reserve(scan.points.size());
    if (!normals.empty()) cloud.normals.reserve(scan.points.size());
    if (labelled) cloud.labels.reserve(scan.points.size());
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        // In double: squares of huge floats would be infinite. NaN fails every comparison.
        const double range = scan.points[i].cast<double>().norm();
        if (!(range >= minRange && range <= maxRange)) continue;
        cloud.points.push_back(scan.points[i]);
        if (!normals.empty()) cloud.normals.push_back(normals[i]);
        if (labelled) cloud.labels.push_back(scan.labels[i]);
    }
    return cloud;
}

}  // namespace leitstand
