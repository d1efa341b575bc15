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

/// Returns whether @p points are of a plane laser: those that are finite have exactly z = 0, and there are
/// some. No other scanner measures such points.
[[nodiscard]] bool isPlaneScan(std::span<const Eigen::Vector3f> points);

/// Returns the labels of all points of @p scan, one a point; Unlabelled where there is no echo or nothing
/// decides. Floor is seen from above (table tops too), Ceiling from below. Points of an organised scan are
/// labelled by their grid normals. Where only the direction along the vertical profile (Sweep) is known, its
/// slope over at least 10 cm decides. Profiles that lean more than 30 degrees do not count: those of a tilted
/// robot, outer ones of a tilting scanner. Points of other scans are labelled by the normals of their nearest
/// neighbours; those of a plane laser are all Wall.
[[nodiscard]] std::vector<Label> labelScan(const Scan& scan, const LabelSettings& settings = {});

/// As above for an organised @p scan, whose gridTangents() and gridNormals() are known.
[[nodiscard]] std::vector<Label> labelScan(const Scan& scan, const GridTangents& tangents,
                                           std::span<const Eigen::Vector3f> normals,
                                           const LabelSettings& settings = {});

/// Returns the labels of points by their @p normals, which point towards the sensor; Unlabelled where a
/// normal is zero.
[[nodiscard]] std::vector<Label> labelNormals(std::span<const Eigen::Vector3f> normals,
                                              const LabelSettings& settings = {});

}  // namespace leitstand
