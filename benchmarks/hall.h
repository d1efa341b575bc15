#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand::benchmarks {

/// A scan of the hall, with what all benchmarks need from it.
struct HallScan {
    Scan scan;         ///< as read: organised, with all points
    PointCloud cloud;  ///< points between 0.48 and 25 m, in scan order; without normals and labels
    Pose guessInFirst = Pose::Identity();  ///< odometry, in the frame of scan000
};

/// The three real scans, which are read once. Throws std::runtime_error when they are missing or cannot be
/// read.
[[nodiscard]] const std::vector<HallScan>& hall();

/// Returns @p points transformed by @p pose [m].
[[nodiscard]] std::vector<Eigen::Vector3f> moved(const Pose& pose,
                                                 const std::vector<Eigen::Vector3f>& points);

}  // namespace leitstand::benchmarks
