#pragma once

#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

struct GridTangents;

/// Normals of an organised @p scan from its grid neighbours: one a point, unit length, towards the sensor;
/// zero where there is no echo or no surface to be told. @p threads: 0 is one per core.
[[nodiscard]] std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, int threads = 1);

/// The same of a scan whose @p tangents are known.
[[nodiscard]] std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, const GridTangents& tangents,
                                                       int threads = 1);

/// Normals of any points from the plane through each one's @p neighbours nearest points, towards @p sensor;
/// zero where the points do not span a plane or are not finite. @p threads: 0 is one per core.
[[nodiscard]] std::vector<Eigen::Vector3f> knnNormals(std::span<const Eigen::Vector3f> points,
                                                      int neighbours = 20,
                                                      const Eigen::Vector3f& sensor = Eigen::Vector3f::Zero(),
                                                      int threads = 1);

}  // namespace leitstand
