#pragma once

#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

struct GridTangents;

/// Returns normals of an organised @p scan, computed from grid neighbours: one per point, of unit length,
/// towards the sensor. Zero where there is no echo or the surface is unknown. @p threads: 0 means one per
/// core.
[[nodiscard]] std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, int threads = 1);

/// As above, for a scan whose gridTangents() are known.
[[nodiscard]] std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, const GridTangents& tangents,
                                                       int threads = 1);

/// Returns normals of any points: one per point, of unit length, towards @p sensor. Each is the normal of the
/// plane through the nearest points, the point itself included; @p neighbours is their number. Zero if these
/// points span no plane, or if the point is not finite. @p threads: 0 means one per core.
[[nodiscard]] std::vector<Eigen::Vector3f> knnNormals(std::span<const Eigen::Vector3f> points,
                                                      int neighbours = 20,
                                                      const Eigen::Vector3f& sensor = Eigen::Vector3f::Zero(),
                                                      int threads = 1);

}  // namespace leitstand
