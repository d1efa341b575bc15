#pragma once

#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

struct GridTangents;

/// Returns normals of an organised @p scan from its grid neighbours: one a point, unit length, towards the
/// sensor. Zero where there is no echo or the surface is unknown. @p threads: 0 is one per core.
[[nodiscard]] std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, int threads = 1);

/// The same for a scan whose @p tangents are known.
[[nodiscard]] std::vector<Eigen::Vector3f> gridNormals(const Scan& scan, const GridTangents& tangents,
                                                       int threads = 1);

/// Returns normals of any points, towards @p sensor, from the plane through each one's @p neighbours nearest
/// points. Zero where these span no plane or are not finite. @p threads: 0 is one per core.
[[nodiscard]] std::vector<Eigen::Vector3f> knnNormals(std::span<const Eigen::Vector3f> points,
                                                      int neighbours = 20,
                                                      const Eigen::Vector3f& sensor = Eigen::Vector3f::Zero(),
                                                      int threads = 1);

}  // namespace leitstand
