#include "core/mapping/scan_preparation.h"

#include <optional>

#include "core/cloud/filters/median_filter.h"
#include "core/cloud/filters/normals.h"
#include "core/cloud/filters/outliers.h"
#include "core/cloud/filters/range_filter.h"
#include "core/cloud/filters/voxel_grid.h"
#include "core/cloud/labels.h"
#include "core/mapping/plane/plane_scan.h"

namespace leitstand {
namespace {

constexpr int NormalNeighbours = 20;
/// Points that hang farther off surfaces are left out before voxels are made [m]. With a smaller value, scans
/// that start far off are registered from fewer places.
constexpr double HangsBy = 0.15;
constexpr double PlaneEdge = 0.05;  ///< of the squares of a plane laser's scan, which are not reduced [m]

PointCloud filtered(const Scan& scan, std::span<const Eigen::Vector3f> normals,
                    const RegistrationSettings& settings) {
    if (settings.filter == ScanFilter::None) {
        return pointsInRange(scan, normals, settings.minRange, settings.maxRange);
    }
    MedianFilterSettings filter;
    filter.minRange = settings.minRange;
    filter.maxRange = settings.maxRange;
    return medianReduced(scan, normals, filter);
}

}  // namespace

ScanPtr labelled(const ScanPtr& scan) {
    if (scan->labels.size() == scan->points.size()) return scan;
    auto copy = std::make_shared<Scan>(*scan);
    copy->labels = labelScan(*scan);
    return copy;
}

PointCloud prepared(const Scan& whole, const RegistrationSettings& settings) {
    if (isPlaneScan(whole.points)) {
        const double edge = settings.reduce > 0.0 ? settings.reduce / 2.0 : PlaneEdge;
        return wallsAndFloor(pointsInRange(whole, {}, settings.minRange, settings.maxRange).points, edge);
    }
    const bool asInPaper = settings.filter != ScanFilter::None;
    std::optional<Scan> solid;
    if (!asInPaper && settings.reduce > 0.0 && whole.organised())
        solid = withoutMixedPixels(whole, {.leastStep = HangsBy});
    const Scan& scan = solid ? *solid : whole;
    const std::vector<Eigen::Vector3f> normals =
        scan.organised() ? gridNormals(scan, settings.threads) : std::vector<Eigen::Vector3f>();
    PointCloud cloud = filtered(scan, normals, settings);
    if (settings.reduce > 0.0)
        cloud = asInPaper ? voxelGrid(cloud, settings.reduce)
                          : voxelGrid(cloud, settings.reduce, settings.kept,
                                      ownGridOrigin(cloud.points, settings.reduce));
    if (cloud.normals.empty()) {
        cloud.normals = knnNormals(cloud.points, NormalNeighbours, Eigen::Vector3f::Zero(), settings.threads);
    }
    return cloud;
}

}  // namespace leitstand
