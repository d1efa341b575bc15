#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/handin/map/map_painter.h"

namespace leitstand {

/// Marks in the picture of a scan.
struct ScanPictureMarks {
    std::optional<Eigen::Vector3d> find;  ///< position in the map
    std::optional<Pose> baseInMap;        ///< pose of the robot
};

/// Paints the scan's @p points, in the map [m], seen from above with the find in the middle. Colours are
/// heights above the robot's base, from -0.2 m (dark blue) to 1.8 m (yellow). The find is a disc, the robot
/// an arrow, and lines are drawn every metre. +x of the map is up, +y is left.
[[nodiscard]] MapPicture scanPicture(const std::vector<Eigen::Vector3d>& points,
                                     const ScanPictureMarks& marks);

}  // namespace leitstand
