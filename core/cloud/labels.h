#pragma once

#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

struct GridTangents;

/// Settings for the semantic labels (paper, section 2.2).
struct LabelSettings {
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< upward direction in the scan's frame
    /// Surfaces up to this slope are floor or ceiling, steeper ones are wall [rad].
    double steepest = degrees(45);
};

/// Returns whether one of @p points is finite and has another z than 0: a plane laser measures none.
[[nodiscard]] bool leavesPlane(std::span<const Eigen::Vector3f> points);
/// Returns whether @p points are of a plane laser: at least 30 are finite, and all finite ones have
/// exactly z = 0. No other scanner measures such points.
[[nodiscard]] bool isPlaneScan(std::span<const Eigen::Vector3f> points);

/// Returns the labels of all points of @p scan, one per point; Unlabelled where there is no echo or nothing
/// decides. Floor is seen from above (including table tops), Ceiling from below. Points of an organised scan
/// are labelled by their grid normals. If only the direction along the vertical profile (Sweep) is known, its
/// slope over at least 10 cm decides. Profiles that lean more than 30 degrees are not used: those of a tilted
/// robot, and outer ones of a tilting scanner. Points of other scans are labelled by the normals of their
/// nearest neighbours; those of a plane laser are all Wall.
[[nodiscard]] std::vector<Label> labelScan(const Scan& scan, const LabelSettings& settings = {});

/// As above for an organised @p scan, whose gridTangents() and gridNormals() are known.
[[nodiscard]] std::vector<Label> labelScan(const Scan& scan, const GridTangents& tangents,
                                           std::span<const Eigen::Vector3f> normals,
                                           const LabelSettings& settings = {});

/// Returns the labels of points from their @p normals, which point towards the sensor. Unlabelled where a
/// normal is zero.
[[nodiscard]] std::vector<Label> labelNormals(std::span<const Eigen::Vector3f> normals,
                                              const LabelSettings& settings = {});

}  // namespace leitstand
