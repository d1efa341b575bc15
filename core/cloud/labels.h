#pragma once

#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

struct GridTangents;

/// Settings of the semantic labels (paper, section 2.2).
struct LabelSettings {
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< against gravity, in the scan's frame
    double steepest = degrees(45);  ///< surfaces up to this slope are floor or ceiling, others wall [rad]
};

/// Labels of all points of @p scan: one a point, Unlabelled where there is no echo or nothing decides.
/// Floor is seen from above (table tops too), Ceiling from below. Organised scans: by the slope along their
/// vertical raw scans, over at least 10 cm, with the direction across it where known, since neither a tilted
/// robot's raw scans nor a tilting scanner's outer ones are vertical. Others: by the normals of their nearest
/// neighbours.
[[nodiscard]] std::vector<Label> labelScan(const Scan& scan, const LabelSettings& settings = {});

/// The same of an organised @p scan whose @p tangents and their @p normals (gridNormals()) are known.
[[nodiscard]] std::vector<Label> labelScan(const Scan& scan, const GridTangents& tangents,
                                           std::span<const Eigen::Vector3f> normals,
                                           const LabelSettings& settings = {});

/// Labels of points by their @p normals, which are towards the sensor; Unlabelled where zero.
[[nodiscard]] std::vector<Label> labelNormals(std::span<const Eigen::Vector3f> normals,
                                              const LabelSettings& settings = {});

}  // namespace leitstand
